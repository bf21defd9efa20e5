#include "engine/passes/hardware_rays.h"

#include <algorithm>

namespace manylight {

void buildMeshStructures(gpu::Device& device, GpuScene& gpuScene, const Scene& scene, const InstanceList& list) {
    std::vector<gpu::TriangleRange> ranges;
    for (const SharedMesh& mesh : list.meshes) {
        const auto first = scene.triangles.begin() + mesh.firstTriangle;
        const bool isOpaque = std::all_of(first, first + mesh.triangleCount, [&](const Triangle& triangle) {
            return scene.materials[triangle.material].alphaMode == AlphaMode::Opaque;
        });
        ranges.push_back({mesh.firstTriangle, mesh.triangleCount, isOpaque});
    }
    gpuScene.meshStructures = gpu::buildBottomLevels(device, gpuScene.triangles.buffer, ranges);
}

void buildSceneStructure(gpu::Device& device, GpuScene& gpuScene, const InstanceList& list) {
    std::vector<gpu::StructureInstance> instances;
    for (const MeshInstance& instance : list.instances)
        instances.push_back({&gpuScene.meshStructures[instance.mesh], instance.sceneFromMesh, instance.center});
    gpuScene.accelerationStructure = {gpu::buildTopLevel(device, instances), {}};
}

uint64_t structureBytes(const GpuScene& gpuScene) {
    uint64_t bytes = gpuScene.accelerationStructure.buffer.exists() ? gpuScene.accelerationStructure.buffer.size() : 0;
    for (const gpu::Buffer& structure : gpuScene.meshStructures)
        if (structure.exists()) bytes += structure.size();
    return bytes;
}

}  // namespace manylight
