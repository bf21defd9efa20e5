#include "engine/scene/normalise.h"

#include "engine/core/check.h"
#include "engine/scene/first_seen_index.h"
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

struct Bounds {
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

std::string placeOf(const RawScene& raw, const RawTriangle& triangle) {
    return fmt::format("{} {}", raw.originLabel, triangle.origin);
}

/// Returns why a triangle cannot be used, or nullptr.
const char* faultOf(const RawScene& raw, const RawTriangle& triangle) {
    for (const uint32_t v : triangle.vertex)
        if (v >= raw.vertices.size()) return "triangles dropped: vertex index out of range";
    const glm::dvec3& a = raw.vertices[triangle.vertex[0]].position;
    const glm::dvec3& b = raw.vertices[triangle.vertex[1]].position;
    const glm::dvec3& c = raw.vertices[triangle.vertex[2]].position;
    if (!isUsable(a) || !isUsable(b) || !isUsable(c)) return "triangles dropped: vertex not finite or beyond 1e150";
    if (hasZeroArea(a, b, c)) return "triangles dropped: zero area";
    return nullptr;
}

template <typename FaultOf>
size_t dropFaultyTriangles(RawScene& raw, Warnings& warnings, const FaultOf& fault) {
    return std::erase_if(raw.triangles, [&](const RawTriangle& triangle) {
        const char* const why = fault(triangle);
        if (why) warnings.add(why, warnings.count(why) < Warnings::kMaxExamples ? placeOf(raw, triangle) : "");
        return why != nullptr;
    });
}

SceneFrame frameAround(const RawScene& raw) {
    SceneFrame frame;
    if (raw.triangles.empty()) return frame;
    Bounds bounds;
    for (const RawTriangle& triangle : raw.triangles)
        for (const uint32_t v : triangle.vertex) bounds.include(raw.vertices[v].position);
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
        raw.materials.push_back({.name = rect.name, .albedo = glm::dvec3(0.0), .emittedRadiance = rect.radiance});
        const glm::dvec2 corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
        for (const glm::dvec2& corner : corners)
            raw.vertices.push_back({.position = rect.center + corner.x * rect.u + corner.y * rect.v});
        raw.triangles.push_back({{first, first + 1, first + 2}, material, 0});
        raw.triangles.push_back({{first, first + 2, first + 3}, material, 0});
    }
}

Positions normalisedPositions(const RawScene& raw, const SceneFrame& frame) {
    Positions positions;
    positions.reserve(raw.vertices.size());
    // Adding zero turns -0 into +0, so that equal vertices have equal bits.
    for (const RawVertex& vertex : raw.vertices) positions.push_back(normalisedPoint(frame, vertex.position) + 0.0f);
    return positions;
}

/// Finds the frame and the positions in it. Triangles that collapse there are dropped, which can shrink the bounds:
/// then it looks again. (The rounded positions go through memory: GCC 12 at -O2 takes a vector's way from double to
/// float and back for no change when both steps meet in one expression.)
Positions settleFrame(RawScene& raw, Scene& scene) {
    for (int round = 0;; ++round) {
        scene.frame = frameAround(raw);
        Positions positions = normalisedPositions(raw, scene.frame);
        const size_t dropped = dropFaultyTriangles(raw, scene.warnings, [&](const RawTriangle& triangle) {
            const auto corner = [&](size_t i) { return glm::dvec3(positions[triangle.vertex[i]]); };
            return hasZeroArea(corner(0), corner(1), corner(2)) ? "triangles dropped: zero area in single precision"
                                                                : nullptr;
        });
        if (dropped == 0 || round == kMostFrameRounds) return positions;
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

/// Converts the vertices that triangles use, welds equal ones and fills Scene::vertices and Scene::triangles.
void convertTriangles(const RawScene& raw, const Positions& positions, Scene& scene) {
    constexpr uint32_t kUnseen = UINT32_MAX;
    std::vector<uint32_t> welded(raw.vertices.size(), kUnseen);
    FirstSeenIndex<WeldKey> vertices(std::min(raw.vertices.size(), 3 * raw.triangles.size()));
    scene.triangles.reserve(raw.triangles.size());
    for (const RawTriangle& source : raw.triangles) {
        MANYLIGHT_CHECK(source.material < raw.materials.size(), "{}", placeOf(raw, source));
        Triangle triangle{.vertex = {}, .material = source.material};
        for (size_t corner = 0; corner < 3; ++corner) {
            uint32_t& index = welded[source.vertex[corner]];
            if (index == kUnseen) {
                const RawVertex& vertex = raw.vertices[source.vertex[corner]];
                index =
                    vertices.indexOf({{positions[source.vertex[corner]], repairedNormal(vertex, scene.warnings) + 0.0f,
                                       repairedUv(vertex.uv, scene.warnings), repairedUv(vertex.uv1, scene.warnings),
                                       repairedColour(vertex.colour, scene.warnings)}});
            }
            triangle.vertex[corner] = index;
        }
        scene.triangles.push_back(triangle);
    }
    scene.vertices.reserve(vertices.keys().size());
    for (const WeldKey& key : vertices.keys()) scene.vertices.push_back(key.vertex);
}

void computeBounds(Scene& scene) {
    if (scene.vertices.empty()) return;
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

Scene normalise(RawScene&& raw) {
    Scene scene;
    scene.name = std::move(raw.name);
    scene.path = std::move(raw.path);
    scene.warnings = std::move(raw.warnings);
    scene.settings = std::move(raw.settings);
    scene.maxDepth = raw.maxDepth;
    scene.textures = std::move(raw.textures);

    const size_t trianglesRead = raw.triangles.size();
    addRectLights(raw);
    dropFaultyTriangles(raw, scene.warnings, [&](const RawTriangle& triangle) { return faultOf(raw, triangle); });
    const Positions positions = settleFrame(raw, scene);
    convertTriangles(raw, positions, scene);
    computeBounds(scene);
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
