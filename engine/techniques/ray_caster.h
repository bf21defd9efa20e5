// Rays alone, without a picture: the traversal of all passes, on a list of rays.
#pragma once

#include "engine/accel/ray_sets.h"
#include "engine/graph/execute.h"
#include "engine/passes/gpu_scene.h"
#include "engine/techniques/settings.h"
#include "shaders/shared/trace_rays.h"

#include <span>
#include <vector>

namespace manylight {

class RayCaster {
  public:
    /// Uploads the scene. Throws Error if the device cannot hold it, or lacks the hardware rays that are asked for.
    RayCaster(gpu::Device& device, const Scene& scene, const Bvh& bvh, RaysBy rays = RaysBy::Software);

    /// Uploads the rays that trace() traces. Throws Error if the device cannot hold them.
    void load(std::span<const shared::RayQuery> rays);

    /// Traces all rays once. Throws Error if the driver cut a ray off.
    Execution trace(RayKind kind);

    /// 1 per ray that met something, 0 for the others. After trace(RayKind::AnyHit).
    std::vector<uint32_t> occludedFlags();
    /// RayHit::triangle is a number of GpuScene::numbers. After trace(RayKind::ClosestHit).
    std::vector<shared::RayHit> hits();

    const GpuScene& gpuScene() const { return gpuScene_; }
    const ScenePlan& plan() const { return plan_; }

  private:
    std::vector<std::byte> answers(RayKind kind);

    gpu::Device& device_;
    ScenePlan plan_;
    GpuScene gpuScene_;
    gpu::PipelineLibrary pipelines_;
    GraphExecutor executor_;
    PhysicalBuffer status_;
    PhysicalBuffer queries_;
    PhysicalBuffer answers_;
    uint32_t rayCount_ = 0;
    RayKind lastKind_ = RayKind::AnyHit;
};

}  // namespace manylight
