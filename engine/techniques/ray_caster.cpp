#include "engine/techniques/ray_caster.h"

#include "engine/core/check.h"
#include "engine/gpu/transfer.h"
#include "engine/gpu/tuning_file.h"
#include "engine/passes/frame_status.h"
#include "engine/passes/trace_rays.h"
#include "engine/techniques/plan_rays.h"

#include <cstring>
#include <limits>

namespace manylight {
namespace {

gpu::Buffer makeBuffer(gpu::Device& device, const char* name, uint64_t bytes, VkBufferUsageFlags usage,
                       VkFormat texelFormat = VK_FORMAT_UNDEFINED) {
    if (bytes > device.limits().maxStorageBufferRange)
        fail("{} of {} MiB: device {} allows {} MiB in one buffer", name, bytes >> 20, device.info().name,
             device.limits().maxStorageBufferRange >> 20);
    constexpr VkBufferUsageFlags kCopies = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    return {device, name, {bytes, usage | kCopies, gpu::MemoryKind::Device, texelFormat}};
}

template <typename T>
std::vector<T> asVector(const std::vector<std::byte>& bytes, size_t count) {
    std::vector<T> values(count);
    std::memcpy(values.data(), bytes.data(), count * sizeof(T));
    return values;
}

ScenePlan planFor(const gpu::Device& device, const Scene& scene, RaysBy rays) {
    ScenePlan plan = planScene(scene);
    planRays(plan, rays, rayAbilities(device));
    return plan;
}

}  // namespace

RayCaster::RayCaster(gpu::Device& device, const Scene& scene, const Bvh& bvh, RaysBy rays)
    : device_(device),
      plan_(planFor(device, scene, rays)),
      gpuScene_(uploadScene(device, scene, plan_, bvh)),
      pipelines_(device),
      executor_(device, pipelines_),
      status_(makeStatusBuffer(device)) {
    Warnings ignored;  // the default traverses as well
    executor_.setTuning(gpu::tuningOf(device, ignored));
    executor_.setTreeDepth(gpuScene_.treeDepth);
}

void RayCaster::load(std::span<const shared::RayQuery> rays) {
    MANYLIGHT_CHECK(rays.size() <= std::numeric_limits<uint32_t>::max() - shared::kMaxRaysPerDispatch, "rays");
    queries_ = {makeBuffer(device_, "ray queries", rays.size_bytes(), VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT,
                           VK_FORMAT_R32G32B32A32_SFLOAT),
                {}};
    answers_ = {
        makeBuffer(device_, "ray answers", rays.size() * sizeof(shared::RayHit), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT),
        {}};
    gpu::Uploader uploader(device_);
    uploader.upload(queries_.buffer, std::as_bytes(rays));
    uploader.flush();
    rayCount_ = static_cast<uint32_t>(rays.size());
}

Execution RayCaster::trace(RayKind kind) {
    MANYLIGHT_CHECK(queries_.buffer.exists(), "trace() before load()");
    FrameGraph graph;
    SceneHandles scene;
    scene.status = importPhysical(graph, "status", status_);
    scene.bvhNodes = importPhysical(graph, "BVH nodes", gpuScene_.bvhNodes);
    scene.triangles = importPhysical(graph, "triangles", gpuScene_.triangles);
    scene.instances = importPhysical(graph, "instances", gpuScene_.instances);
    scene.accelerationStructure = importStructure(graph, gpuScene_);
    addStatusReset(graph, scene);
    RayBuffers rays{importPhysical(graph, "ray queries", queries_), importPhysical(graph, "ray answers", answers_)};
    addTraceRays(graph, scene, plan_, rays, rayCount_, kind);
    graph.keep(rays.answers);
    addStatusReadback(graph, scene);
    Execution execution = executor_.execute(graph);
    lastKind_ = kind;
    if (readStatus(status_).loopBudgetExceeded != 0)
        fail("device {} ended a ray before its time (its loop limit was met): the answers would be wrong",
             device_.info().name);
    return execution;
}

std::vector<std::byte> RayCaster::answers(RayKind kind) {
    MANYLIGHT_CHECK(lastKind_ == kind, "answers to another question");
    const VkDeviceSize size = VkDeviceSize{rayCount_} * answerBytes(kind);
    if (size == 0) return {};
    PhysicalBuffer copy{gpu::Buffer(device_, "ray answers on the host",
                                    {size, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::MemoryKind::Readback}),
                        {}};
    FrameGraph graph;
    const BufferHandle source = importPhysical(graph, "ray answers", answers_);
    PassBuilder pass = graph.addPass("answers_copy");
    pass.read(source, Access::TransferRead);
    const BufferHandle target =
        pass.write(importPhysical(graph, "ray answers on the host", copy), Access::TransferWrite);
    pass.execute([=](PassContext& context) { context.copy(source, 0, size, target); });
    graph.addPass("answers_readback").read(target, Access::HostRead).keep("the host reads the answers");
    executor_.execute(graph);
    std::vector<std::byte> bytes(size);
    std::memcpy(bytes.data(), copy.buffer.mapped(), size);
    return bytes;
}

std::vector<uint32_t> RayCaster::occludedFlags() { return asVector<uint32_t>(answers(RayKind::AnyHit), rayCount_); }

std::vector<shared::RayHit> RayCaster::hits() {
    return asVector<shared::RayHit>(answers(RayKind::ClosestHit), rayCount_);
}

}  // namespace manylight
