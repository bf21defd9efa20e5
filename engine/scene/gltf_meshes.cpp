#include "engine/scene/gltf_meshes.h"

#include "engine/scene/gltf_materials.h"
#include "engine/scene/gltf_skins.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace manylight {
namespace {

/// From a mesh into the scene, for all of its vertices or for one that follows joints.
struct VertexTransform {
    glm::dmat3 linear;
    glm::dvec3 offset;
    glm::dmat3 ofNormals;  // the cofactor matrix: the inverse transpose times the determinant, also for flat scales
    bool isMirrored;

    explicit VertexTransform(const glm::dmat4& m)
        : linear(m),
          offset(m[3]),
          ofNormals(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                    glm::cross(linear[0], linear[1])),
          isMirrored(glm::determinant(linear) < 0.0) {
        if (isMirrored) ofNormals = -ofNormals;
    }
};

/// Corner numbers of triangle `t` in a list, strip or fan.
std::array<size_t, 3> cornersOf(int mode, size_t t) {
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) return {t, t + 1 + t % 2, t + 2 - t % 2};
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN) return {t + 1, t + 2, 0};
    return {3 * t, 3 * t + 1, 3 * t + 2};
}

/// Makes room at once, in steps that grow: primitives may be many.
template <typename T>
void reserveMore(std::vector<T>& elements, size_t more) {
    const size_t needed = elements.size() + more;
    if (needed > elements.capacity()) elements.reserve(std::max(needed, 2 * elements.capacity()));
}

class PrimitiveReader {
  public:
    PrimitiveReader(const GltfFile& gltf, const tinygltf::Primitive& primitive, const GltfShape& shape,
                    const glm::dmat4& sceneFromNode, bool turnsWinding, std::string place, RawScene& scene)
        : gltf_(gltf),
          primitive_(primitive),
          shape_(shape),
          sceneFromNode_(sceneFromNode),
          place_(std::move(place)),
          scene_(scene),
          turnsWinding_(turnsWinding) {}

    void read() {
        const int mode = primitive_.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive_.mode;
        if (mode < TINYGLTF_MODE_TRIANGLES) return scene_.warnings.add("point and line primitives dropped", place_);
        const auto positions = readAttribute("POSITION");
        if (!positions) return scene_.warnings.add("primitives dropped: no positions", place_);
        if (primitive_.attributes.contains("COLOR_1"))
            scene_.warnings.add("vertex colours beyond the first set ignored", place_);
        const size_t firstVertex = scene_.vertices.size();
        checkGltfAmount(gltf_, firstVertex + positions->size() / 3, place_, "vertices");
        addVertices(*positions);
        addTriangles(mode, firstVertex);
    }

  private:
    /// As the morph targets make it.
    std::optional<std::vector<double>> readAttribute(const std::string& name) const {
        const auto found = primitive_.attributes.find(name);
        if (found == primitive_.attributes.end()) return std::nullopt;
        std::vector<double> numbers = readGltfNumbers(gltf_, found->second);
        if (shape_.morph) addMorphTargets(gltf_, primitive_, name, *shape_.morph, numbers);
        return numbers;
    }

    std::optional<GltfSkinning> skinning() const {
        if (!shape_.sceneFromBound) return std::nullopt;
        if (hasGltfJoints(primitive_))
            return GltfSkinning(gltf_, primitive_, *shape_.sceneFromBound, place_, scene_.warnings);
        scene_.warnings.add("primitives with a skin but without joints: they stay with their node", place_);
        return std::nullopt;
    }

    void addVertices(const std::vector<double>& positions) {
        const GltfUvSets sets = gltfUvSets(gltf_, primitive_.material);
        const auto normals = readAttribute("NORMAL");
        const auto uvs = readAttribute(fmt::format("TEXCOORD_{}", sets[0]));
        const auto uvs1 = readAttribute(fmt::format("TEXCOORD_{}", sets[1]));
        const auto colours = readAttribute("COLOR_0");
        const std::optional<GltfSkinning> joints = skinning();
        VertexTransform transform(sceneFromNode_);
        const size_t colourSize = colours ? colours->size() / (positions.size() / 3) : 0;
        reserveMore(scene_.vertices, positions.size() / 3);
        for (size_t i = 0; i < positions.size() / 3; ++i) {
            if (joints) {
                transform = VertexTransform(joints->sceneFromVertex(i));
                isMirrored_.push_back(transform.isMirrored);
            }
            RawVertex vertex;
            const glm::dvec3 position(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
            vertex.position = transform.linear * position + transform.offset;
            vertex.hasNormal = normals.has_value();
            if (normals)
                vertex.normal =
                    transform.ofNormals * glm::dvec3((*normals)[3 * i], (*normals)[3 * i + 1], (*normals)[3 * i + 2]);
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
        reserveMore(scene_.triangles, count);
        for (size_t t = 0; t < count; ++t) {
            RawTriangle triangle{.vertex = {}, .material = material, .origin = 0};
            triangle.origin = static_cast<uint32_t>(scene_.triangles.size());
            const std::array<size_t, 3> corners = cornersOf(mode, t);
            bool isInside = true;
            std::array<uint32_t, 3> vertices{};
            for (size_t i = 0; i < 3; ++i) {
                vertices[i] = indices[corners[i]];
                isInside = isInside && vertices[i] < vertexCount;
            }
            if (!isInside) {
                scene_.warnings.add("triangles dropped: vertex index out of range", place_);
                continue;
            }
            const bool turns = turnsWinding(vertices);
            for (size_t i = 0; i < 3; ++i)
                triangle.vertex[i] = static_cast<uint32_t>(firstVertex + vertices[turns ? 2 - i : i]);
            scene_.triangles.push_back(triangle);
        }
    }

    /// A triangle that follows joints is turned inside out where they turn most of its corners.
    bool turnsWinding(const std::array<uint32_t, 3>& vertices) const {
        if (isMirrored_.empty()) return turnsWinding_;
        return std::ranges::count_if(vertices, [&](uint32_t vertex) { return bool{isMirrored_[vertex]}; }) >= 2;
    }

    const GltfFile& gltf_;
    const tinygltf::Primitive& primitive_;
    const GltfShape& shape_;
    const glm::dmat4& sceneFromNode_;
    std::string place_;
    RawScene& scene_;
    bool turnsWinding_;
    std::vector<bool> isMirrored_;  // by vertex, of those that follow joints
};

}  // namespace

void addGltfMesh(const GltfFile& gltf, int mesh, const GltfShape& shape, const glm::dmat4& sceneFromNode,
                 bool turnsWinding, RawScene& scene) {
    const tinygltf::Mesh& source = gltf.model.meshes.at(static_cast<size_t>(mesh));
    for (size_t i = 0; i < source.primitives.size(); ++i)
        PrimitiveReader(gltf, source.primitives[i], shape, sceneFromNode, turnsWinding,
                        fmt::format("meshes[{}].primitives[{}]", mesh, i), scene)
            .read();
}

}  // namespace manylight
