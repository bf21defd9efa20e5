#include "engine/scene/gltf_meshes.h"

#include "engine/scene/gltf_materials.h"

#include <numeric>
#include <optional>

namespace manylight {
namespace {

using Attributes = std::map<std::string, int>;

std::optional<std::vector<double>> readAttribute(const GltfFile& gltf, const Attributes& attributes,
                                                 const std::string& name) {
    const auto found = attributes.find(name);
    if (found == attributes.end()) return std::nullopt;
    return readGltfNumbers(gltf, found->second);
}

/// Transforms normals: the cofactor matrix is the inverse transpose times the determinant and exists for flat scales.
glm::dmat3 normalMatrix(const glm::dmat3& m, bool isMirrored) {
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return isMirrored ? -cofactors : cofactors;
}

/// Corner numbers of triangle `t` in a list, strip or fan.
std::array<size_t, 3> cornersOf(int mode, size_t t) {
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) return {t, t + 1 + t % 2, t + 2 - t % 2};
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN) return {t + 1, t + 2, 0};
    return {3 * t, 3 * t + 1, 3 * t + 2};
}

class PrimitiveReader {
  public:
    PrimitiveReader(const GltfFile& gltf, const tinygltf::Primitive& primitive, const glm::dmat4& sceneFromNode,
                    bool turnsWinding, std::string place, RawScene& scene)
        : gltf_(gltf),
          primitive_(primitive),
          sceneFromNode_(sceneFromNode),
          place_(std::move(place)),
          scene_(scene),
          turnsWinding_(turnsWinding) {}

    void read() {
        const int mode = primitive_.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive_.mode;
        if (mode < TINYGLTF_MODE_TRIANGLES) return scene_.warnings.add("point and line primitives dropped", place_);
        const auto positions = readAttribute(gltf_, primitive_.attributes, "POSITION");
        if (!positions) return scene_.warnings.add("primitives dropped: no positions", place_);
        if (!primitive_.targets.empty()) scene_.warnings.add("morph targets ignored", place_);
        if (primitive_.attributes.contains("COLOR_1"))
            scene_.warnings.add("vertex colours beyond the first set ignored", place_);
        const size_t firstVertex = scene_.vertices.size();
        checkGltfAmount(gltf_, firstVertex + positions->size() / 3, place_, "vertices");
        addVertices(*positions);
        addTriangles(mode, firstVertex);
    }

  private:
    void addVertices(const std::vector<double>& positions) {
        const glm::dmat3 linear(sceneFromNode_);
        const glm::dmat3 normalFromNode = normalMatrix(linear, glm::determinant(linear) < 0.0);
        const GltfUvSets sets = gltfUvSets(gltf_, primitive_.material);
        const auto normals = readAttribute(gltf_, primitive_.attributes, "NORMAL");
        const auto uvs = readAttribute(gltf_, primitive_.attributes, fmt::format("TEXCOORD_{}", sets[0]));
        const auto uvs1 = readAttribute(gltf_, primitive_.attributes, fmt::format("TEXCOORD_{}", sets[1]));
        const auto colours = readAttribute(gltf_, primitive_.attributes, "COLOR_0");
        const size_t colourSize = colours ? colours->size() / (positions.size() / 3) : 0;
        for (size_t i = 0; i < positions.size() / 3; ++i) {
            RawVertex vertex;
            const glm::dvec3 position(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
            vertex.position = linear * position + glm::dvec3(sceneFromNode_[3]);
            vertex.hasNormal = normals.has_value();
            if (normals)
                vertex.normal =
                    normalFromNode * glm::dvec3((*normals)[3 * i], (*normals)[3 * i + 1], (*normals)[3 * i + 2]);
            if (uvs) vertex.uv = {(*uvs)[2 * i], (*uvs)[2 * i + 1]};
            if (uvs1) vertex.uv1 = {(*uvs1)[2 * i], (*uvs1)[2 * i + 1]};
            for (size_t c = 0; c < colourSize; ++c) vertex.colour[static_cast<int>(c)] = (*colours)[colourSize * i + c];
            scene_.vertices.push_back(vertex);
        }
    }

    void addTriangles(int mode, size_t firstVertex) {
        const size_t vertexCount = scene_.vertices.size() - firstVertex;
        std::vector<uint32_t> indices;
        if (primitive_.indices >= 0)
            indices = readGltfIndices(gltf_, primitive_.indices);
        else {
            indices.resize(vertexCount);
            std::iota(indices.begin(), indices.end(), 0u);
        }
        const bool isList = mode == TINYGLTF_MODE_TRIANGLES;
        const size_t count = isList ? indices.size() / 3 : indices.size() < 3 ? 0 : indices.size() - 2;
        checkGltfAmount(gltf_, scene_.triangles.size() + count, place_, "triangles");
        if (count == 0 || (isList && indices.size() % 3 != 0))
            scene_.warnings.add("primitives with an incomplete triangle", place_);
        const auto material = primitive_.material < 0 ? static_cast<uint32_t>(gltf_.model.materials.size())
                                                      : static_cast<uint32_t>(primitive_.material);
        for (size_t t = 0; t < count; ++t) {
            RawTriangle triangle{.vertex = {}, .material = material, .origin = 0};
            triangle.origin = static_cast<uint32_t>(scene_.triangles.size());
            const std::array<size_t, 3> corners = cornersOf(mode, t);
            bool isInside = true;
            for (size_t i = 0; i < 3; ++i) {
                const uint32_t index = indices[corners[turnsWinding_ ? 2 - i : i]];
                isInside = isInside && index < vertexCount;
                triangle.vertex[i] = static_cast<uint32_t>(firstVertex + index);
            }
            if (isInside)
                scene_.triangles.push_back(triangle);
            else
                scene_.warnings.add("triangles dropped: vertex index out of range", place_);
        }
    }

    const GltfFile& gltf_;
    const tinygltf::Primitive& primitive_;
    const glm::dmat4& sceneFromNode_;
    std::string place_;
    RawScene& scene_;
    bool turnsWinding_;
};

}  // namespace

void addGltfMesh(const GltfFile& gltf, int mesh, const glm::dmat4& sceneFromNode, bool turnsWinding, RawScene& scene) {
    const tinygltf::Mesh& source = gltf.model.meshes.at(static_cast<size_t>(mesh));
    for (size_t i = 0; i < source.primitives.size(); ++i)
        PrimitiveReader(gltf, source.primitives[i], sceneFromNode, turnsWinding,
                        fmt::format("meshes[{}].primitives[{}]", mesh, i), scene)
            .read();
}

}  // namespace manylight
