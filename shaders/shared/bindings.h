// Binding numbers, each once. Everything is in descriptor set 0.
#ifndef MANYLIGHT_SHARED_BINDINGS_H
#define MANYLIGHT_SHARED_BINDINGS_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

MANYLIGHT_CONSTANT(int, kBindingFrame, 0);              // uniform: FrameConstants
MANYLIGHT_CONSTANT(int, kBindingBvhNodes, 1);           // storage texel buffer, RGBA32_UINT: kBvhTexelsPerNode each
MANYLIGHT_CONSTANT(int, kBindingTriangles, 2);          // storage texel buffer, RGBA32_UINT: three texels per triangle
MANYLIGHT_CONSTANT(int, kBindingTriangleMaterials, 3);  // storage: uint per triangle
MANYLIGHT_CONSTANT(int, kBindingTriangleUvs, 4);        // storage: kUvSets vec2 per corner of a triangle
MANYLIGHT_CONSTANT(int, kBindingMaterials, 5);          // storage: Material
MANYLIGHT_CONSTANT(int, kBindingTextureInfos, 6);       // storage: TextureInfo
MANYLIGHT_CONSTANT(int, kBindingTexels, 7);             // storage texel buffer, RGBA8_UNORM
MANYLIGHT_CONSTANT(int, kBindingEmitters, 8);           // storage texel buffer, RGBA32_UINT: Emitter
MANYLIGHT_CONSTANT(int, kBindingRays, 9);               // storage: Ray per path of the batch
MANYLIGHT_CONSTANT(int, kBindingPathOffsets, 10);       // storage: vertices per path, then their prefix sum
MANYLIGHT_CONSTANT(int, kBindingPathVertices, 11);      // storage: LightData, slot = (depth - 1) * paths + path
MANYLIGHT_CONSTANT(int, kBindingVpls, 12);              // storage or uniform: LightData
MANYLIGHT_CONSTANT(int, kBindingPathStates, 13);        // storage: PathState per pixel of the band
MANYLIGHT_CONSTANT(int, kBindingStatus, 14);            // storage: FrameStatus
MANYLIGHT_CONSTANT(int, kBindingVisibility, 15);        // image R32_UINT: triangle + 1, 0 where there is none
MANYLIGHT_CONSTANT(int, kBindingGBufferPosition, 16);   // image RGBA32_UINT: position, triangle + 1
MANYLIGHT_CONSTANT(int, kBindingGBufferShading, 17);    // image RGBA32_UINT: normal, albedo
MANYLIGHT_CONSTANT(int, kBindingRadiance, 18);          // image RGBA32F: radiance of this frame
MANYLIGHT_CONSTANT(int, kBindingRadianceSum, 19);       // image RGBA32F: sum over frames
MANYLIGHT_CONSTANT(int, kBindingDisplay, 20);           // image RGBA8: what is shown
MANYLIGHT_CONSTANT(int, kBindingVplTexels, 21);         // storage texel buffer, RGBA32F: kTexelsPerLight per VPL
MANYLIGHT_CONSTANT(int, kBindingRayQueries, 22);        // storage texel buffer, RGBA32F: two texels per RayQuery
MANYLIGHT_CONSTANT(int, kBindingRayAnswers, 23);        // storage: RayHit or a uint flag per RayQuery
MANYLIGHT_CONSTANT(int, kBindingRoundingError, 24);     // image RGBA32F: what the sum over frames lost by rounding
MANYLIGHT_CONSTANT(int, kBindingSquaredDeviations, 25); // image RGBA32F: from the mean, summed over frames
MANYLIGHT_CONSTANT(int, kBindingTriangleColours, 26);   // storage: three RGBA16 per triangle
MANYLIGHT_CONSTANT(int, kBindingPathGloss, 27);         // storage: VplGloss per entry of kBindingPathVertices
MANYLIGHT_CONSTANT(int, kBindingVplGloss, 28);          // storage, or texel buffer RGBA32F: VplGloss per VPL
MANYLIGHT_CONSTANT(int, kBindingGBufferGloss, 29);      // image RGBA32_UINT: reflectance at normal incidence, alpha
MANYLIGHT_CONSTANT(int, kBindingEmitterChoices, 30);    // storage texel buffer, RGBA32_UINT: EmitterChoice per emitter
MANYLIGHT_CONSTANT(int, kBindingEnvironmentTexels, 31); // storage texel buffer, RGBA32F: radiance, row by row
MANYLIGHT_CONSTANT(int, kBindingEnvironmentCells, 32);  // storage texel buffer, RGBA32_UINT: EnvironmentCell

MANYLIGHT_CONSTANT(int, kBindingOtherDisplay, 60);      // image RGBA8: what is shown beyond the divider
MANYLIGHT_CONSTANT(int, kBindingCanvas, 61);            // image RGBA8: the whole window
MANYLIGHT_CONSTANT(int, kBindingPanelVertices, 62);     // storage: PanelVertex
MANYLIGHT_CONSTANT(int, kBindingPanelIndices, 63);      // storage: uint per corner of a triangle
MANYLIGHT_CONSTANT(int, kBindingPanelAtlas, 64);        // storage: coverage of four texels per uint
MANYLIGHT_CONSTANT(int, kBindingReconstructed, 70);     // image RGBA32F: light, and its standard error; before a filter's pass
MANYLIGHT_CONSTANT(int, kBindingReconstruction, 71);    // image RGBA32F: the same after it
MANYLIGHT_CONSTANT(int, kBindingGuide, 72);              // image RGBA32F: normal, depth along the camera's axis
MANYLIGHT_CONSTANT(int, kBindingUnshadowed, 73);         // image RGBA32F: light as if nothing were between
MANYLIGHT_CONSTANT(int, kBindingLentLight, 74);          // image RGBA32F: light at other points of the pixels
MANYLIGHT_CONSTANT(int, kBindingShown, 112);            // image RGBA32F: sum over frames as it is shown, and frames that it stands for
MANYLIGHT_CONSTANT(int, kBindingHistory, 113);          // image RGBA32_UINT: what earlier views knew of a pixel
MANYLIGHT_CONSTANT(int, kBindingHistoryGuide, 114);     // image RGBA32_UINT: what the next view has to know of a pixel
MANYLIGHT_CONSTANT(int, kBindingInstances, 36);         // storage texel buffer, RGBA32_UINT: kTexelsPerInstance per Instance
MANYLIGHT_CONSTANT(int, kBindingAccelerationStructure, 57); // of the instances, for hardware rays

MANYLIGHT_SHARED_END
#endif
