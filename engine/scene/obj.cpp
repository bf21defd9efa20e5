#include "engine/scene/obj.h"

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/image/srgb.h"
#include "engine/scene/first_seen_index.h"
#include "engine/scene/obj_materials.h"
#include "engine/scene/obj_statements.h"
#include "engine/scene/triangulate.h"

#include <algorithm>
#include <span>

namespace manylight {
namespace {

struct CornerKey {
    ObjCorner corner;

    bool operator==(const CornerKey& other) const {
        return corner.position == other.corner.position && corner.uv == other.corner.uv &&
               corner.normal == other.corner.normal;
    }
    uint64_t hash() const {
        const auto bits = [](int32_t index) { return uint64_t{static_cast<uint32_t>(index)}; };
        const uint64_t h = mixHash(mixHash(0, bits(corner.position) << 32 | bits(corner.uv)), bits(corner.normal));
        return h ^ (h >> 32);
    }
};

using CornerIndex = FirstSeenIndex<CornerKey>;

void warnOfFace(Warnings& warnings, std::string_view kind, const ObjFace& face) {
    const bool wantsPlace = warnings.count(kind) < Warnings::kMaxExamples;
    warnings.add(kind, wantsPlace ? fmt::format("line {}", face.line) : "");
}

/// Clears a corner index that points nowhere. Indices may point forward, so this waits for the end of the file.
void clearIfOutside(int32_t& index, size_t count, const ObjFace& face, std::string_view kind, Warnings& warnings) {
    if (index == kNoIndex || static_cast<size_t>(index) < count) return;
    index = kNoIndex;
    warnOfFace(warnings, kind, face);
}

/// False if a corner has no position.
bool checkIndices(const ObjStatements& obj, const ObjFace& face, std::span<ObjCorner> corners, Warnings& warnings) {
    for (ObjCorner& corner : corners) {
        if (static_cast<size_t>(corner.position) >= obj.positions.size()) {
            warnOfFace(warnings, "faces dropped: vertex index out of range", face);
            return false;
        }
        clearIfOutside(corner.uv, obj.uvs.size(), face, "texture coordinate indices out of range", warnings);
        clearIfOutside(corner.normal, obj.normals.size(), face, "normal indices out of range", warnings);
    }
    return true;
}

void addTriangles(ObjStatements& obj, RawScene& scene, CornerIndex& vertices) {
    std::vector<glm::dvec3> points;
    std::vector<std::array<uint32_t, 3>> pieces;
    for (const ObjFace& face : obj.faces) {
        const std::span<ObjCorner> corners(obj.corners.data() + face.firstCorner, face.cornerCount);
        if (!checkIndices(obj, face, corners, scene.warnings)) continue;
        points.clear();
        for (const ObjCorner& corner : corners) points.push_back(obj.positions[static_cast<size_t>(corner.position)]);
        if (!triangulate(points, pieces))
            warnOfFace(scene.warnings, "polygons split by guess: self-intersecting or very large", face);
        for (const auto& piece : pieces) {
            RawTriangle triangle{.vertex = {}, .material = face.material, .origin = face.line};
            for (size_t i = 0; i < 3; ++i) triangle.vertex[i] = vertices.indexOf({corners[piece[i]]});
            scene.triangles.push_back(triangle);
        }
    }
}

/// Decodes sRGB. What is outside [0, 1] stays there, to be counted with all others.
glm::dvec3 linearColour(glm::dvec3 colour) {
    for (int channel = 0; channel < 3; ++channel)
        if (colour[channel] > 0.0 && colour[channel] < 1.0)
            colour[channel] = decodeSrgb(static_cast<float>(colour[channel]));
    return colour;
}

void addVertices(const ObjStatements& obj, const CornerIndex& vertices, RawScene& scene) {
    scene.vertices.reserve(vertices.keys().size());
    for (const CornerKey& key : vertices.keys()) {
        RawVertex vertex;
        vertex.position = obj.positions[static_cast<size_t>(key.corner.position)];
        if (!obj.colours.empty())
            vertex.colour = glm::dvec4(linearColour(obj.colours[static_cast<size_t>(key.corner.position)]), 1.0);
        vertex.hasNormal = key.corner.normal != kNoIndex;
        if (vertex.hasNormal) vertex.normal = obj.normals[static_cast<size_t>(key.corner.normal)];
        if (key.corner.uv != kNoIndex) {
            const glm::dvec2 uv = obj.uvs[static_cast<size_t>(key.corner.uv)];
            vertex.uv = {uv.x, 1.0 - uv.y};
        }
        scene.vertices.push_back(vertex);
    }
}

}  // namespace

RawScene readObj(const std::filesystem::path& path) {
    RawScene scene;
    scene.name = path.stem().string();
    scene.path = path;
    scene.originLabel = "line";
    ObjStatements obj = parseObj(readTextFile(path), path.string(), scene.warnings);
    CornerIndex vertices(obj.positions.size() + obj.positions.size() / 4);
    scene.triangles.reserve(obj.corners.size() - 2 * obj.faces.size());
    addTriangles(obj, scene, vertices);
    addVertices(obj, vertices, scene);
    readObjMaterials(path.parent_path(), obj.materialLibraries, obj.materialNames, scene);
    return scene;
}

}  // namespace manylight
