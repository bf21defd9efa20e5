// The scene on the device: what ScenePlan says it needs, and nothing else.
#pragma once

#include "engine/accel/top_level.h"
#include "engine/core/report.h"
#include "engine/graph/pass_context.h"
#include "engine/scene/emitters.h"
#include "engine/scene/scene_plan.h"
#include "shaders/shared/material.h"

namespace manylight {

struct GpuScene {
    PhysicalBuffer bvhNodes;
    PhysicalBuffer triangles;          // corners with packed normals, in leaf order; also the vertex buffer
    PhysicalBuffer triangleMaterials;  // one index per triangle
    PhysicalBuffer triangleUvs;        // plan.uvSets for each corner, if textured
    PhysicalBuffer triangleColours;    // three per triangle, if some are not white
    PhysicalBuffer materials;
    PhysicalBuffer textureInfos;
    PhysicalBuffer texels;
    PhysicalBuffer emitters;
    PhysicalBuffer emitterChoices;     // if there are several emitters
    PhysicalBuffer environmentTexels;  // if there is a map
    PhysicalBuffer environmentCells;
    glm::uvec2 environmentSize{0};  // of EnvironmentTable
    uint32_t environmentCellSide = 1;
    float environmentTurn = 0.0f;
    PhysicalBuffer instances;  // if there are two levels
    // With hardware rays, instead of BVH nodes:
    std::vector<gpu::Buffer> meshStructures;
    PhysicalBuffer accelerationStructure;  // of the instances

    uint32_t triangleCount = 0;       // with all repeats
    uint32_t instanceCount = 0;       // 0: every triangle is in the scene's frame
    TriangleNumbers numbers;          // of the triangles that the device talks of
    std::vector<uint32_t> meshRoots;  // nodes, before those of the upper level are counted
    std::vector<Bounds> instanceBounds;
    std::vector<shared::Material> packedMaterials;  // as uploaded
    std::vector<DrawRange> draws;                   // all triangles, for rasterisation
    EmitterTable emitterTable;
    BoundingSphere sphere;
    double surfaceArea = 0.0;    // of all triangles, normalised frame
    float meanAlbedo = 0.0f;     // area-weighted, largest channel
    uint64_t geometryBytes = 0;  // triangles, materials' indices, uvs and BVH
    uint64_t totalBytes = 0;
    Json report() const;  // bytes, bytes per triangle, BVH nodes and depth
    uint64_t bvhNodeCount = 0;
    uint32_t bvhDepth = 0;
    uint32_t treeDepth = 0;  // of the deepest mesh, or of all triangles where none is shared
};

/// Uploads through staging and waits. Throws Error if the device cannot hold the scene.
GpuScene uploadScene(gpu::Device& device, const Scene& scene, const ScenePlan& plan, const Bvh& bvh);

/// After a change of the scene's lights and of what its materials emit; its surfaces are those that were uploaded. The
/// device must be idle.
void replaceEmitters(gpu::Device& device, GpuScene& gpuScene, const Scene& scene, const ScenePlan& plan);
/// After instances and lights of the scene have moved, nothing else: renews the upper level and the emitters. The
/// number of instances is what it was. The device must be idle.
void moveInstances(gpu::Device& device, GpuScene& gpuScene, const Scene& scene, const ScenePlan& plan);

/// The scene's buffers in one frame's graph.
struct SceneHandles {
    BufferHandle frame;
    BufferHandle status;
    BufferHandle bvhNodes;
    BufferHandle triangles;
    BufferHandle triangleMaterials;
    BufferHandle triangleUvs;
    BufferHandle triangleColours;
    BufferHandle materials;
    BufferHandle textureInfos;
    BufferHandle texels;
    BufferHandle emitters;
    BufferHandle emitterChoices;
    BufferHandle environmentTexels;
    BufferHandle environmentCells;
    BufferHandle instances;
    std::optional<BufferHandle> accelerationStructure;
};
std::optional<BufferHandle> importStructure(FrameGraph& graph, GpuScene& scene);
SceneHandles importScene(FrameGraph& graph, GpuScene& scene, PhysicalBuffer& frame, PhysicalBuffer& status);

enum class PipelineKind : uint8_t { Compute, Graphics };

/// Declares that a pass looks up surfaces: frame constants, BVH, triangles (a graphics pass also draws them),
/// materials and textures.
void readSurfaces(PassBuilder& pass, const SceneHandles& scene, PipelineKind kind);
/// Declares that a pass traces rays: with hardware rays it runs the entry points that are compiled for them.
void readRays(PassBuilder& pass, const SceneHandles& scene, PipelineKind kind);
/// Declares that a pass draws emitters, and what the environment shows.
void readEmitters(PassBuilder& pass, const SceneHandles& scene, PipelineKind kind);
/// Declares that a pass reads the frame constants.
void readFrame(PassBuilder& pass, const SceneHandles& scene, PipelineKind kind);

}  // namespace manylight
