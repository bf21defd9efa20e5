// The scene's acceleration structures: what rays traverse where the device does it itself.
#pragma once

#include "engine/gpu/acceleration_structure.h"
#include "engine/passes/gpu_scene.h"

namespace manylight {

/// One structure per mesh, over gpuScene.triangles: triangles in it are in leaf order, as elsewhere.
void buildMeshStructures(gpu::Device& device, GpuScene& gpuScene, const Scene& scene, const InstanceList& list);
/// The structure over all instances, counted as in the list; anew whenever they have moved. The device must be idle.
void buildSceneStructure(gpu::Device& device, GpuScene& gpuScene, const InstanceList& list);

uint64_t structureBytes(const GpuScene& gpuScene);

}  // namespace manylight
