#include "engine/accel/build_tree.h"
#include "engine/accel/embree.h"
#include "engine/core/check.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>

namespace manylight {

namespace {

// Handles that Embree keeps for us are an index + 1, as null means failure.
void* toHandle(size_t index) { return reinterpret_cast<void*>(index + 1); }
uint32_t toIndex(const void* handle) { return static_cast<uint32_t>(reinterpret_cast<uintptr_t>(handle) - 1); }

void* createNode(RTCThreadLocalAllocator, unsigned int, void* user) {
    auto& tree = *static_cast<BuildTree*>(user);
    tree.nodes.emplace_back();
    return toHandle(tree.nodes.size() - 1);
}

void setChildren(void* handle, void** children, unsigned int, void* user) {
    auto& tree = *static_cast<BuildTree*>(user);
    tree.nodes[toIndex(handle)].children = {toIndex(children[0]), toIndex(children[1])};
}

// The boxes of inner nodes are merged from the leaves' afterwards.
void ignoreBounds(void*, const RTCBounds**, unsigned int, void*) {}

void* createLeaf(RTCThreadLocalAllocator, const RTCBuildPrimitive* primitives, size_t count, void* user) {
    auto& tree = *static_cast<BuildTree*>(user);
    BuildNode& leaf = tree.nodes.emplace_back();
    leaf.first = static_cast<uint32_t>(tree.order.size());
    leaf.count = static_cast<uint32_t>(count);
    for (size_t i = 0; i < count; ++i) tree.order.push_back(primitives[i].primID);
    std::sort(tree.order.end() - static_cast<std::ptrdiff_t>(count), tree.order.end());
    return toHandle(tree.nodes.size() - 1);
}

std::vector<RTCBuildPrimitive> toPrimitives(const std::vector<Box>& boxes) {
    std::vector<RTCBuildPrimitive> primitives(boxes.size());
    for (size_t i = 0; i < boxes.size(); ++i) {
        const auto& [lower, upper] = boxes[i];
        primitives[i] = {lower.x, lower.y, lower.z, 0, upper.x, upper.y, upper.z, static_cast<uint32_t>(i)};
    }
    return primitives;
}

void mergeBoxesUpwards(BuildTree& tree, const std::vector<Box>& boxes) {
    for (size_t i = tree.nodes.size(); i-- > 0;) {
        BuildNode& node = tree.nodes[i];
        if (node.count == 0) {
            MANYLIGHT_CHECK(std::min(node.children[0], node.children[1]) > i, "Embree made a child before its parent");
            node.box = merge(tree.nodes[node.children[0]].box, tree.nodes[node.children[1]].box);
            continue;
        }
        node.box = boxes[tree.order[node.first]];
        for (uint32_t k = 1; k < node.count; ++k) node.box = merge(node.box, boxes[tree.order[node.first + k]]);
    }
}

}  // namespace

BuildTree buildSahTree(const std::vector<Box>& boxes, const BvhOptions& options) {
    BuildTree tree;
    if (boxes.empty()) return tree;
    // One thread: Embree's partition depends on the number of threads where centres coincide.
    const std::unique_ptr<RTCDeviceTy, void (*)(RTCDevice)> device(rtcNewDevice("threads=1"), rtcReleaseDevice);
    if (!device) fail("Embree: no device (error {})", static_cast<int>(rtcGetDeviceError(nullptr)));
    const std::unique_ptr<RTCBVHTy, void (*)(RTCBVH)> bvh(rtcNewBVH(device.get()), rtcReleaseBVH);
    std::vector<RTCBuildPrimitive> primitives = toPrimitives(boxes);

    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
    arguments.maxBranchingFactor = 2;
    arguments.maxDepth = 40;  // of the binary tree, of which a node of the BVH spans about two levels
    arguments.maxLeafSize = options.maxLeafSize;
    arguments.traversalCost = options.traversalCost;
    arguments.intersectionCost = options.intersectionCost;
    arguments.bvh = bvh.get();
    arguments.primitives = primitives.data();
    arguments.primitiveCount = primitives.size();
    arguments.primitiveArrayCapacity = primitives.size();
    arguments.createNode = createNode;
    arguments.setNodeChildren = setChildren;
    arguments.setNodeBounds = ignoreBounds;
    arguments.createLeaf = createLeaf;
    arguments.userPtr = &tree;
    // "threads=1" is not kept while another Embree device with more threads lives; an arena of one is.
    bool isBuilt = false;
    tbb::task_arena(1).execute([&] { isBuilt = rtcBuildBVH(&arguments) != nullptr; });
    if (!isBuilt) {
        fail("Embree: BVH of {} triangles not built (error {})", boxes.size(),
             static_cast<int>(rtcGetDeviceError(device.get())));
    }
    mergeBoxesUpwards(tree, boxes);
    return tree;
}

}  // namespace manylight
