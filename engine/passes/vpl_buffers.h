// The VPL list in a frame's graph.
#pragma once

#include "engine/passes/gpu_scene.h"

namespace manylight {

struct VplBuffers {
    BufferHandle list;   // LightData, padded with dark ones to a multiple of shared::kVplPadding
    BufferHandle gloss;  // VplGloss for each; a single one where the scene has no glossy surfaces
};

/// Not yet written.
VplBuffers createVplBuffers(FrameGraph& graph, const ScenePlan& plan, uint32_t vplCount);

/// Declares that a pass reads VPLs as texels.
void readVpls(PassBuilder& pass, const VplBuffers& vpls, PipelineKind kind);

/// A buffer that copyVplsToHost() fills, for that many VPLs.
PhysicalBuffer makeVplCopy(gpu::Device& device, uint32_t vplCount);

/// Lets the host read `list` after the frame.
void copyVplsToHost(FrameGraph& graph, BufferHandle list, PhysicalBuffer& copy);

/// Entries of the list with its padding.
uint32_t paddedVplCount(uint32_t vplCount);

}  // namespace manylight
