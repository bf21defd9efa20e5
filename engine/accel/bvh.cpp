#include "engine/accel/bvh.h"

#include "engine/accel/build_tree.h"
#include "engine/core/check.h"
#include "shaders/shared/packing.h"

#include <algorithm>
#include <cstring>

namespace manylight {

namespace {

bool fitsStacks(const Bvh& bvh) {
    return bvh.depth < static_cast<uint32_t>(shared::kBvhStackSize) && bvh.putAside <= shared::kBvhShortStackSize;
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
    Bvh bvh = layoutTree(buildSahTree(boxes, options));
    // Input made to defeat the heuristic can be deeper than a traversal's stack.
    if (!fitsStacks(bvh)) bvh = layoutTree(buildBalancedTree(boxes, options));
    MANYLIGHT_CHECK(bvh.triangleOrder.size() == scene.triangles.size(), "buildBvh");
    MANYLIGHT_CHECK(fitsStacks(bvh), "buildBvh");
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
