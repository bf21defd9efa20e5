#include "engine/accel/top_level.h"

#include "engine/accel/build_tree.h"
#include "engine/core/check.h"

#include <algorithm>

namespace manylight {
namespace {

/// A ray that starts d away is off by about d * 2^-22 in the scene once it is in a mesh's frame.
Box withRoom(const Bounds& bounds) {
    const glm::vec3 size = bounds.high - bounds.low;
    const float room = 0x1p-19f + 0x1p-18f * std::max({size.x, size.y, size.z});
    return {bounds.low - room, bounds.high + room};
}

bool fitsStack(const Bvh& bvh) { return bvh.depth < static_cast<uint32_t>(shared::kBvhStackSize); }

glm::vec3 rowOf(const glm::mat3& m, int row) { return {m[0][row], m[1][row], m[2][row]}; }

}  // namespace

TopLevel buildTopLevel(const std::vector<Bounds>& ofInstances) {
    std::vector<Box> boxes;
    for (const Bounds& bounds : ofInstances) boxes.push_back(withRoom(bounds));
    constexpr BvhOptions kOneEach{.maxLeafSize = 1};
    Bvh bvh = layoutTree(buildSahTree(boxes, kOneEach));
    if (!fitsStack(bvh)) bvh = layoutTree(buildBalancedTree(boxes, kOneEach));
    MANYLIGHT_CHECK(fitsStack(bvh), "depth of the upper level");
    MANYLIGHT_CHECK(bvh.nodes.size() <= std::max<size_t>(boxes.size(), 1), "nodes of the upper level");
    return {std::move(bvh.nodes), std::move(bvh.triangleOrder), bvh.depth};
}

std::vector<shared::Instance> packInstances(const InstanceList& list, const std::vector<uint32_t>& roots,
                                            const TopLevel& top, uint32_t firstNode) {
    std::vector<shared::Instance> records;
    records.reserve(list.instances.size() + 1);
    for (size_t i = 0; i < list.instances.size(); ++i) {
        const MeshInstance& instance = list.instances[i];
        const glm::mat3 meshFromScene(glm::inverse(glm::dmat3(instance.sceneFromMesh)));
        records.push_back({
            .meshFromScene0 = rowOf(meshFromScene, 0),
            .bvhRoot = firstNode + roots[instance.mesh],
            .meshFromScene1 = rowOf(meshFromScene, 1),
            .numberOffset = list.firstNumbers[i] - list.meshes[instance.mesh].firstTriangle,
            .meshFromScene2 = rowOf(meshFromScene, 2),
            .firstNumber = list.firstNumbers[i],
            .center = instance.center,
            .instanceOfLeaf = top.order[i],
            .sceneFromMesh0 = rowOf(instance.sceneFromMesh, 0),
            .instanceCount = static_cast<uint32_t>(list.instances.size()),
            .sceneFromMesh1 = rowOf(instance.sceneFromMesh, 1),
            .unused1 = 0,
            .sceneFromMesh2 = rowOf(instance.sceneFromMesh, 2),
            .unused2 = 0,
        });
    }
    records.push_back({});
    records.back().firstNumber = list.triangleCount();
    return records;
}

void appendNodes(std::vector<shared::BvhNode>& nodes, const std::vector<shared::BvhNode>& more,
                 uint32_t firstTriangle) {
    const auto firstNode = static_cast<uint32_t>(nodes.size());
    nodes.insert(nodes.end(), more.begin(), more.end());
    if (nodes.size() > size_t{1} << 24) fail("the BVH has more than 2^24 nodes: fewer triangles are expected");
    for (size_t i = firstNode; i < nodes.size(); ++i) {
        const uint32_t child = (nodes[i].firstChildAndLeaves & 0xffffffu) + firstNode;
        // Past the last node where there is no inner child: as good as any other.
        nodes[i].firstChildAndLeaves = (nodes[i].firstChildAndLeaves & 0xff000000u) | (child & 0xffffffu);
        nodes[i].firstTriangle += firstTriangle;
    }
}

TriangleNumbers::TriangleNumbers(InstanceList list, std::vector<uint32_t> triangleOrder)
    : list_(std::move(list)), order_(std::move(triangleOrder)), place_(order_.size()) {
    for (uint32_t place = 0; place < order_.size(); ++place) place_[order_[place]] = place;
}

size_t TriangleNumbers::instanceOf(uint32_t number) const {
    MANYLIGHT_CHECK(number < count(), "triangle numbers");
    const auto after = std::ranges::upper_bound(list_.firstNumbers, number);
    return static_cast<size_t>(after - list_.firstNumbers.begin()) - 1;
}

uint32_t TriangleNumbers::sceneTriangle(uint32_t number) const {
    const size_t instance = instanceOf(number);
    const SharedMesh& mesh = list_.meshes[list_.instances[instance].mesh];
    return order_[number - list_.firstNumbers[instance] + mesh.firstTriangle];
}

uint32_t TriangleNumbers::flattenedTriangle(uint32_t number) const {
    const size_t instance = instanceOf(number);
    const SharedMesh& mesh = list_.meshes[list_.instances[instance].mesh];
    return sceneTriangle(number) - mesh.firstTriangle + list_.firstNumbers[instance];
}

uint32_t TriangleNumbers::numberOfFlattened(uint32_t triangle) const {
    const size_t instance = instanceOf(triangle);
    const SharedMesh& mesh = list_.meshes[list_.instances[instance].mesh];
    return place_[triangle - list_.firstNumbers[instance] + mesh.firstTriangle] - mesh.firstTriangle +
           list_.firstNumbers[instance];
}

}  // namespace manylight
