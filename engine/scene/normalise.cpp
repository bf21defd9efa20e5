#include "engine/scene/normalise.h"

#include "engine/core/check.h"
#include "engine/scene/first_seen_index.h"
#include "engine/scene/instances.h"
#include "engine/scene/normalise_parts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace manylight {
namespace {

// Beyond this, differences and squares of coordinates leave the range of double.
constexpr double kLargestCoordinate = 1e150;
constexpr int kMostFrameRounds = 8;

using Positions = std::vector<glm::vec3>;  // one per raw vertex, in the normalised frame

struct RawBounds {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void include(const glm::dvec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
};

struct WeldKey {
    Vertex vertex;

    bool operator==(const WeldKey& other) const {
        return vertex.position == other.vertex.position && vertex.normal == other.vertex.normal &&
               vertex.uv == other.vertex.uv && vertex.uv1 == other.vertex.uv1 && vertex.colour == other.vertex.colour;
    }
    uint64_t hash() const {
        const auto word = [](float a, float b) {
            return uint64_t{std::bit_cast<uint32_t>(a)} << 32 | std::bit_cast<uint32_t>(b);
        };
        uint64_t h = mixHash(0, word(vertex.position.x, vertex.position.y));
        h = mixHash(h, word(vertex.position.z, vertex.normal.x));
        h = mixHash(h, word(vertex.normal.y, vertex.normal.z));
        h = mixHash(h, word(vertex.uv.x, vertex.uv.y));
        h = mixHash(h, word(vertex.uv1.x, vertex.uv1.y));
        h = mixHash(h, word(vertex.colour.x, vertex.colour.y));
        h = mixHash(h, word(vertex.colour.z, vertex.colour.w));
        return h ^ (h >> 32);
    }
};

bool isUsable(const glm::dvec3& p) {
    return std::abs(p.x) < kLargestCoordinate && std::abs(p.y) < kLargestCoordinate &&
           std::abs(p.z) < kLargestCoordinate;  // false for NaN
}

/// Scales an edge by a power of two so that its largest component is in [1, 2); leaves the zero vector.
glm::dvec3 withoutExponent(const glm::dvec3& edge) {
    const double largest = std::max({std::abs(edge.x), std::abs(edge.y), std::abs(edge.z)});
    if (largest == 0.0) return edge;
    const int exponent = std::ilogb(largest);
    return {std::ldexp(edge.x, -exponent), std::ldexp(edge.y, -exponent), std::ldexp(edge.z, -exponent)};
}

bool hasZeroArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::cross(withoutExponent(b - a), withoutExponent(c - a)) == glm::dvec3(0.0);
}

/// The triangles of the scene itself, or of a mesh that instances show.
struct Part {
    std::vector<RawVertex>& vertices;
    std::vector<RawTriangle>& triangles;
    const std::string& originLabel;
};

std::string placeOf(const Part& part, const RawTriangle& triangle) {
    return fmt::format("{} {}", part.originLabel, triangle.origin);
}

/// Returns why a triangle cannot be used, or nullptr.
const char* faultOf(const Part& part, const RawTriangle& triangle) {
    for (const uint32_t v : triangle.vertex)
        if (v >= part.vertices.size()) return "triangles dropped: vertex index out of range";
    const glm::dvec3& a = part.vertices[triangle.vertex[0]].position;
    const glm::dvec3& b = part.vertices[triangle.vertex[1]].position;
    const glm::dvec3& c = part.vertices[triangle.vertex[2]].position;
    if (!isUsable(a) || !isUsable(b) || !isUsable(c)) return "triangles dropped: vertex not finite or beyond 1e150";
    if (hasZeroArea(a, b, c)) return "triangles dropped: zero area";
    return nullptr;
}

template <typename FaultOf>
size_t dropFaultyTriangles(const Part& part, Warnings& warnings, const FaultOf& fault) {
    return std::erase_if(part.triangles, [&](const RawTriangle& triangle) {
        const char* const why = fault(triangle);
        if (why) warnings.add(why, warnings.count(why) < Warnings::kMaxExamples ? placeOf(part, triangle) : "");
        return why != nullptr;
    });
}

/// Round the part, and round `others` if there are any.
SceneFrame frameAround(const Part& part, const RawBounds& others) {
    SceneFrame frame;
    RawBounds bounds = others;
    for (const RawTriangle& triangle : part.triangles)
        for (const uint32_t v : triangle.vertex) bounds.include(part.vertices[v].position);
    if (bounds.low.x > bounds.high.x) return frame;
    const glm::dvec3 extent = bounds.high - bounds.low;
    frame.center = bounds.low + 0.5 * extent;
    frame.exponent = std::ilogb(std::hypot(extent.x, extent.y, extent.z));
    return frame;
}

/// Two triangles per rectangle, counter-clockwise seen from the side that cross(u, v) points to.
void addRectLights(RawScene& raw) {
    for (const RawRectLight& rect : raw.rectLights) {
        const auto first = static_cast<uint32_t>(raw.vertices.size());
        const auto material = static_cast<uint32_t>(raw.materials.size());
        raw.materials.push_back({.name = rect.name,
                                 .albedo = glm::dvec3(0.0),
                                 .emittedRadiance = rect.radiance,
                                 .emissionScale = rect.emissionScale});
        const glm::dvec2 corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
        for (const glm::dvec2& corner : corners)
            raw.vertices.push_back({.position = rect.center + corner.x * rect.u + corner.y * rect.v});
        raw.triangles.push_back({{first, first + 1, first + 2}, material, 0});
        raw.triangles.push_back({{first, first + 2, first + 3}, material, 0});
    }
}

Positions normalisedPositions(const Part& part, const SceneFrame& frame) {
    Positions positions;
    positions.reserve(part.vertices.size());
    // Adding zero turns -0 into +0, so that equal vertices have equal bits.
    for (const RawVertex& vertex : part.vertices) positions.push_back(normalisedPoint(frame, vertex.position) + 0.0f);
    return positions;
}

struct Settled {
    SceneFrame frame;
    Positions positions;
};

/// Finds the frame and the positions in it. Triangles that collapse there are dropped, which can shrink the bounds:
/// then it looks again. (The rounded positions go through memory: GCC 12 at -O2 takes a vector's way from double to
/// float and back for no change when both steps meet in one expression.)
Settled settleFrame(const Part& part, const RawBounds& others, Warnings& warnings) {
    for (int round = 0;; ++round) {
        const SceneFrame frame = frameAround(part, others);
        Positions positions = normalisedPositions(part, frame);
        const size_t dropped = dropFaultyTriangles(part, warnings, [&](const RawTriangle& triangle) {
            const auto corner = [&](size_t i) { return glm::dvec3(positions[triangle.vertex[i]]); };
            return hasZeroArea(corner(0), corner(1), corner(2)) ? "triangles dropped: zero area in single precision"
                                                                : nullptr;
        });
        if (dropped == 0 || round == kMostFrameRounds) return {frame, std::move(positions)};
    }
}

glm::vec3 repairedNormal(const RawVertex& vertex, Warnings& warnings) {
    if (!vertex.hasNormal) return glm::vec3(0.0f);
    const double length = std::hypot(vertex.normal.x, vertex.normal.y, vertex.normal.z);
    // A denormal normal has lost its direction; so has one whose length overflows.
    if (!(length >= double{std::numeric_limits<float>::min()}) || !std::isfinite(length)) {
        warnings.add("vertex normals removed: zero, denormal or not finite");
        return glm::vec3(0.0f);
    }
    return glm::vec3(vertex.normal / length);
}

glm::vec2 repairedUv(const glm::dvec2& raw, Warnings& warnings) {
    const glm::vec2 uv(raw);
    if (std::isfinite(uv.x) && std::isfinite(uv.y)) return uv + 0.0f;
    warnings.add("texture coordinates set to zero: not finite");
    return glm::vec2(0.0f);
}

glm::vec4 repairedColour(const glm::dvec4& raw, Warnings& warnings) {
    const glm::dvec4 inRange = glm::clamp(raw, 0.0, 1.0);
    if (inRange == raw) return glm::vec4(raw) + 0.0f;
    warnings.add("vertex colours brought into [0, 1]");
    return glm::vec4(std::isnan(raw.x + raw.y + raw.z + raw.w) ? glm::dvec4(1.0) : inRange) + 0.0f;
}

/// Converts the vertices that triangles use, welds equal ones and adds them to Scene::vertices and Scene::triangles.
void convertTriangles(const Part& part, const Positions& positions, size_t materialCount, Scene& scene) {
    constexpr uint32_t kUnseen = UINT32_MAX;
    const auto firstVertex = static_cast<uint32_t>(scene.vertices.size());
    std::vector<uint32_t> welded(part.vertices.size(), kUnseen);
    FirstSeenIndex<WeldKey> vertices(std::min(part.vertices.size(), 3 * part.triangles.size()));
    scene.triangles.reserve(scene.triangles.size() + part.triangles.size());
    for (const RawTriangle& source : part.triangles) {
        MANYLIGHT_CHECK(source.material < materialCount, "{}", placeOf(part, source));
        Triangle triangle{.vertex = {}, .material = source.material};
        for (size_t corner = 0; corner < 3; ++corner) {
            uint32_t& index = welded[source.vertex[corner]];
            if (index == kUnseen) {
                const RawVertex& vertex = part.vertices[source.vertex[corner]];
                index =
                    vertices.indexOf({{positions[source.vertex[corner]], repairedNormal(vertex, scene.warnings) + 0.0f,
                                       repairedUv(vertex.uv, scene.warnings), repairedUv(vertex.uv1, scene.warnings),
                                       repairedColour(vertex.colour, scene.warnings)}});
            }
            triangle.vertex[corner] = firstVertex + index;
        }
        scene.triangles.push_back(triangle);
    }
    scene.vertices.reserve(scene.vertices.size() + vertices.keys().size());
    for (const WeldKey& key : vertices.keys()) scene.vertices.push_back(key.vertex);
}

/// The shared meshes, each in a frame of its own, in which its diagonal is in [1, 2) too.
void convertMeshes(RawScene& raw, Scene& scene) {
    for (RawMesh& mesh : raw.meshes) {
        const Part part{mesh.vertices, mesh.triangles, raw.originLabel};
        dropFaultyTriangles(part, scene.warnings, [&](const RawTriangle& triangle) { return faultOf(part, triangle); });
        const Settled settled = settleFrame(part, {}, scene.warnings);
        const auto first = static_cast<uint32_t>(scene.triangles.size());
        convertTriangles(part, settled.positions, raw.materials.size(), scene);
        scene.meshes.push_back({first, static_cast<uint32_t>(scene.triangles.size()) - first, settled.frame});
    }
}

glm::dvec3 filePoint(const SceneFrame& frame, const glm::vec3& point) {
    return frame.center + std::ldexp(1.0, frame.exponent) * glm::dvec3(point);
}

RawBounds boundsOfInstances(const RawScene& raw, const Scene& scene) {
    RawBounds bounds;
    for (const RawInstance& instance : raw.instances) {
        const SharedMesh& mesh = scene.meshes[instance.mesh];
        for (uint32_t k = 0; k < mesh.triangleCount; ++k)
            for (const uint32_t vertex : scene.triangles[mesh.firstTriangle + k].vertex) {
                const glm::dvec3 point = filePoint(mesh.frame, scene.vertices[vertex].position);
                bounds.include(instance.sceneFromMesh * glm::dvec4(point, 1.0));
            }
    }
    for (const glm::dvec3& point : raw.framePoints)
        if (isUsable(point)) bounds.include(point);
    return bounds;
}

/// What is no instance of a shared mesh becomes one mesh more, with one instance.
void convertInstances(const RawScene& raw, uint32_t firstOwnTriangle, Scene& scene) {
    if (raw.instances.empty()) return scene.meshes.clear();
    placeInstances(raw, scene);
    const auto ownCount = static_cast<uint32_t>(scene.triangles.size()) - firstOwnTriangle;
    if (ownCount > 0) {
        scene.instances.push_back({.mesh = static_cast<uint32_t>(scene.meshes.size()), .source = kNoSource});
        scene.meshes.push_back({firstOwnTriangle, ownCount, scene.frame});
    } else if (scene.instances.empty()) {
        scene.triangles.clear();
        scene.vertices.clear();
        scene.meshes.clear();
    }
}

void computeBounds(Scene& scene) {
    if (scene.vertices.empty()) return;
    if (!scene.instances.empty()) {
        return setBounds(scene, manylight::boundsOfInstances(scene, listInstances(scene)));
    }
    scene.boundsMin = scene.boundsMax = scene.vertices.front().position;
    for (const Vertex& vertex : scene.vertices) {
        scene.boundsMin = glm::min(scene.boundsMin, vertex.position);
        scene.boundsMax = glm::max(scene.boundsMax, vertex.position);
    }
}

}  // namespace

glm::vec3 normalisedPoint(const SceneFrame& frame, const glm::dvec3& point) {
    return glm::vec3((point - frame.center) * std::ldexp(1.0, -frame.exponent));
}

void includeInBounds(Scene& scene, const std::vector<glm::dvec3>& points) {
    for (const glm::dvec3& point : points) {
        if (!isUsable(point)) continue;
        scene.boundsMin = glm::min(scene.boundsMin, normalisedPoint(scene.frame, point));
        scene.boundsMax = glm::max(scene.boundsMax, normalisedPoint(scene.frame, point));
    }
}

void placeInstances(const RawScene& raw, Scene& scene) {
    constexpr float kSmallest = 0x1p-21f;
    std::erase_if(scene.instances, [](const MeshInstance& instance) { return instance.source != kNoSource; });
    std::vector<MeshInstance> placed;
    for (uint32_t i = 0; i < raw.instances.size(); ++i) {
        const RawInstance& source = raw.instances[i];
        const SharedMesh& mesh = scene.meshes[source.mesh];
        if (mesh.triangleCount == 0) continue;
        const double scale = std::ldexp(1.0, mesh.frame.exponent - scene.frame.exponent);
        const glm::dvec3 center = source.sceneFromMesh * glm::dvec4(mesh.frame.center, 1.0);
        const glm::mat3 m(scale * glm::dmat3(source.sceneFromMesh));
        if (std::max({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])}) < kSmallest)
            scene.warnings.add("instances of meshes dropped: less than a millionth of the scene");
        else
            placed.push_back({source.mesh, m, normalisedPoint(scene.frame, center), i});
    }
    scene.instances.insert(scene.instances.begin(), placed.begin(), placed.end());
}

Scene normalise(RawScene&& raw) {
    Scene scene;
    scene.name = std::move(raw.name);
    scene.path = std::move(raw.path);
    scene.warnings = std::move(raw.warnings);
    scene.settings = std::move(raw.settings);
    scene.maxDepth = raw.maxDepth;
    scene.textures = std::move(raw.textures);

    size_t trianglesRead = raw.triangles.size();
    for (const RawMesh& mesh : raw.meshes) trianglesRead += mesh.triangles.size();
    addRectLights(raw);
    const Part own{raw.vertices, raw.triangles, raw.originLabel};
    dropFaultyTriangles(own, scene.warnings, [&](const RawTriangle& triangle) { return faultOf(own, triangle); });
    convertMeshes(raw, scene);
    const auto firstOwnTriangle = static_cast<uint32_t>(scene.triangles.size());
    const Settled settled = settleFrame(own, boundsOfInstances(raw, scene), scene.warnings);
    scene.frame = settled.frame;
    convertTriangles(own, settled.positions, raw.materials.size(), scene);
    convertInstances(raw, firstOwnTriangle, scene);
    scene.sharing = raw.sharing;
    scene.animationEnd = raw.animationEnd;
    computeBounds(scene);
    includeInBounds(scene, raw.framePoints);
    if (scene.triangles.empty()) scene.warnings.add("scenes without triangles");

    convertMaterials(raw, scene);
    convertLights(raw, scene);
    convertEnvironment(raw, scene);
    convertCameras(raw, scene);
    addMissingCamera(scene);
    if (raw.lightsAreFinal)
        reportMissingLight(scene);
    else
        addMissingLight(scene);
    fillImportReport(scene, trianglesRead);
    return scene;
}

}  // namespace manylight
