#include "engine/accel/bvh.h"

#include "engine/accel/build_tree.h"
#include "engine/accel/top_level.h"
#include "engine/core/check.h"
#include "shaders/shared/packing.h"

#include <algorithm>
#include <cstring>

namespace manylight {

namespace {

bool fitsStacks(const Bvh& bvh) {
    return bvh.depth < static_cast<uint32_t>(shared::kBvhStackSize) && bvh.putAside <= shared::kBvhShortStackSize;
}

Bvh buildTree(const std::vector<Box>& boxes, const BvhOptions& options) {
    Bvh bvh = layoutTree(buildSahTree(boxes, options));
    // Input made to defeat the heuristic can be deeper than a traversal's stack.
    if (!fitsStacks(bvh)) bvh = layoutTree(buildBalancedTree(boxes, options));
    MANYLIGHT_CHECK(fitsStacks(bvh), "buildBvh");
    return bvh;
}

/// One tree per mesh, one behind the other.
Bvh buildTrees(const Scene& scene, const std::vector<Box>& boxes, const BvhOptions& options) {
    Bvh all;
    all.roots.clear();
    for (const SharedMesh& mesh : scene.meshes) {
        MANYLIGHT_CHECK(mesh.firstTriangle == all.triangleOrder.size(), "meshes one behind the other");
        const auto first = boxes.begin() + mesh.firstTriangle;
        const Bvh bvh = buildTree({first, first + mesh.triangleCount}, options);
        all.roots.push_back(static_cast<uint32_t>(all.nodes.size()));
        appendNodes(all.nodes, bvh.nodes, mesh.firstTriangle);
        for (const uint32_t triangle : bvh.triangleOrder) all.triangleOrder.push_back(mesh.firstTriangle + triangle);
        all.depth = std::max(all.depth, bvh.depth);
        all.putAside = std::max(all.putAside, bvh.putAside);
    }
    return all;
}

}  // namespace

Bvh buildBvh(const Scene& scene, const BvhOptions& options) {
    MANYLIGHT_CHECK(options.maxLeafSize >= 1u, "buildBvh");
    MANYLIGHT_CHECK(options.maxLeafSize <= shared::kBvhMaxLeafSize, "buildBvh");
    if (scene.triangles.size() > shared::kBvhMaxTriangles) {
        fail("{}: {} triangles, the BVH holds at most {}", scene.path.string(), scene.triangles.size(),
             shared::kBvhMaxTriangles);
    }
    const std::vector<Box> boxes = triangleBoxes(scene);
    Bvh bvh = scene.instances.empty() ? buildTree(boxes, options) : buildTrees(scene, boxes, options);
    MANYLIGHT_CHECK(bvh.triangleOrder.size() == scene.triangles.size(), "buildBvh");
    return bvh;
}

std::vector<glm::vec4> packTriangles(const Scene& scene, const Bvh& bvh) {
    std::vector<glm::vec4> corners;
    corners.reserve(bvh.triangleOrder.size() * 3);
    for (const uint32_t triangleIndex : bvh.triangleOrder) {
        const Triangle& triangle = scene.triangles[triangleIndex];
        const bool isSmooth = std::ranges::all_of(
            triangle.vertex, [&](uint32_t v) { return scene.vertices[v].normal != glm::vec3(0.0f); });
        for (const uint32_t vertexIndex : triangle.vertex) {
            const Vertex& vertex = scene.vertices[vertexIndex];
            const uint32_t normal = isSmooth ? shared::packUnitVector(vertex.normal) : shared::kNoNormal;
            glm::vec4& corner = corners.emplace_back(vertex.position, 0.0f);
            std::memcpy(&corner.w, &normal, sizeof(normal));
        }
    }
    return corners;
}

}  // namespace manylight
