#include "apps/bench/stability/parts.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace manylight {
namespace {

/// Vertices with the positions of others become one: index of the first of equals.
std::vector<uint32_t> weldedByPosition(const Scene& scene) {
    std::map<std::tuple<float, float, float>, uint32_t> first;
    std::vector<uint32_t> welded(scene.vertices.size());
    for (uint32_t i = 0; i < scene.vertices.size(); ++i) {
        const glm::vec3& p = scene.vertices[i].position;
        welded[i] = first.try_emplace({p.x, p.y, p.z}, i).first->second;
    }
    return welded;
}

uint32_t rootOf(std::vector<uint32_t>& parent, uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

/// Edges, each as often as it is there, forwards and backwards counted apart.
bool isClosed(const Scene& scene, const std::vector<uint32_t>& welded, const std::vector<uint32_t>& triangles) {
    std::unordered_map<uint64_t, int> edges;
    for (const uint32_t t : triangles)
        for (size_t corner = 0; corner < 3; ++corner) {
            const uint64_t a = welded[scene.triangles[t].vertex[corner]];
            const uint64_t b = welded[scene.triangles[t].vertex[(corner + 1) % 3]];
            if (a == b || ++edges[a << 32 | b] > 1) return false;
        }
    return std::all_of(edges.begin(), edges.end(),
                       [&](const auto& edge) { return edges.contains(edge.first << 32 | edge.first >> 32); });
}

Scene partOf(const Scene& scene, const std::vector<uint32_t>& triangles) {
    Scene part;
    part.name = scene.name;
    part.path = scene.path;
    part.frame = scene.frame;
    part.materials.resize(1);
    std::unordered_map<uint32_t, uint32_t> index;
    for (const uint32_t t : triangles) {
        Triangle triangle;
        for (size_t corner = 0; corner < 3; ++corner) {
            const uint32_t vertex = scene.triangles[t].vertex[corner];
            const auto [entry, isNew] = index.try_emplace(vertex, static_cast<uint32_t>(part.vertices.size()));
            if (isNew) part.vertices.push_back({.position = scene.vertices[vertex].position});
            triangle.vertex[corner] = entry->second;
        }
        part.triangles.push_back(triangle);
    }
    return part;
}

}  // namespace

std::vector<Scene> closedParts(const Scene& scene, size_t most) {
    const std::vector<uint32_t> welded = weldedByPosition(scene);
    std::vector<uint32_t> parent(scene.vertices.size());
    std::iota(parent.begin(), parent.end(), 0u);
    for (const Triangle& triangle : scene.triangles)
        for (const uint32_t vertex : triangle.vertex)
            parent[rootOf(parent, welded[vertex])] = rootOf(parent, welded[triangle.vertex[0]]);
    std::map<uint32_t, std::vector<uint32_t>> groups;
    for (uint32_t t = 0; t < scene.triangles.size(); ++t)
        groups[rootOf(parent, welded[scene.triangles[t].vertex[0]])].push_back(t);
    std::vector<const std::vector<uint32_t>*> bySize;
    for (const auto& [root, triangles] : groups) bySize.push_back(&triangles);
    std::stable_sort(bySize.begin(), bySize.end(), [](const auto* a, const auto* b) { return a->size() > b->size(); });
    std::vector<Scene> parts;
    for (const auto* triangles : bySize)
        if (parts.size() < most && triangles->size() >= 4 && isClosed(scene, welded, *triangles))
            parts.push_back(partOf(scene, *triangles));
    return parts;
}

std::vector<InnerEdge> innerEdges(const Scene& scene) {
    struct Use {
        InnerEdge edge;
        uint32_t count = 0;
    };
    const std::vector<uint32_t> welded = weldedByPosition(scene);
    std::unordered_map<uint64_t, Use> uses;
    for (const Triangle& triangle : scene.triangles)
        for (size_t corner = 0; corner < 3; ++corner) {
            const uint32_t a = welded[triangle.vertex[corner]];
            const uint32_t b = welded[triangle.vertex[(corner + 1) % 3]];
            Use& use = uses[uint64_t{std::min(a, b)} << 32 | std::max(a, b)];
            use.edge.ends[0] = a;
            use.edge.ends[1] = b;
            if (use.count < 2) use.edge.opposite[use.count] = triangle.vertex[(corner + 2) % 3];
            ++use.count;
        }
    std::vector<InnerEdge> edges;
    for (const auto& [key, use] : uses)
        if (use.count == 2 && use.edge.ends[0] != use.edge.ends[1]) edges.push_back(use.edge);
    std::sort(edges.begin(), edges.end(), [](const InnerEdge& a, const InnerEdge& b) {
        return std::tie(a.ends[0], a.ends[1]) < std::tie(b.ends[0], b.ends[1]);
    });
    return edges;
}

double signedVolume(const Scene& closed) {
    double volume = 0.0;
    for (const Triangle& triangle : closed.triangles) {
        const glm::dvec3 a = closed.vertices[triangle.vertex[0]].position;
        const glm::dvec3 b = closed.vertices[triangle.vertex[1]].position;
        const glm::dvec3 c = closed.vertices[triangle.vertex[2]].position;
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return volume;
}

}  // namespace manylight
