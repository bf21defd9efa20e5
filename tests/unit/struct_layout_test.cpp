// The structs that both languages compile lie in memory alike: offsets and strides from the SPIR-V against C++.
#include "engine/gpu/shader.h"
#include "shaders/shared/frame.h"
#include "shaders/shared/lights.h"
#include "shaders/shared/material.h"
#include "shaders/shared/path_trace.h"
#include "shaders/shared/reconstruct.h"
#include "shaders/shared/show.h"
#include "shaders/shared/temporal.h"
#include "shaders/shared/tonemap.h"
#include "shaders/shared/trace_rays.h"
#include "shaders/shared/visibility_rays.h"
#include "shaders/shared/vpl_emission.h"
#include "shaders/shared/vpl_light.h"
#include "shaders/shared/vpl_resample.h"
#include "shaders/shared/window.h"
#include "tests/unit/spirv_layout.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>

namespace manylight {
namespace {

using Offsets = std::map<std::string, uint32_t>;

struct ExpectedStruct {
    Offsets offsets;
    uint32_t size;
};

#define MEMBER(type, member) {#member, static_cast<uint32_t>(offsetof(shared::type, member))}

const std::map<std::string, ExpectedStruct> kStructs = {
    {"FrameConstants",
     {{MEMBER(FrameConstants, clipFromWorld),
       MEMBER(FrameConstants, cameraPosition),
       MEMBER(FrameConstants, seed),
       MEMBER(FrameConstants, cameraRight),
       MEMBER(FrameConstants, frame),
       MEMBER(FrameConstants, cameraDown),
       MEMBER(FrameConstants, emitterCount),
       MEMBER(FrameConstants, cameraForward),
       MEMBER(FrameConstants, deltaLightCount),
       MEMBER(FrameConstants, imageSize),
       MEMBER(FrameConstants, pixelOffset),
       MEMBER(FrameConstants, sceneCenter),
       MEMBER(FrameConstants, sceneRadius),
       MEMBER(FrameConstants, environmentRadiance),
       MEMBER(FrameConstants, geometryBound),
       MEMBER(FrameConstants, pathCount),
       MEMBER(FrameConstants, vplCount),
       MEMBER(FrameConstants, lightSampleCount),
       MEMBER(FrameConstants, triangleCount),
       MEMBER(FrameConstants, bounceCount),
       MEMBER(FrameConstants, emitterPowerShare),
       MEMBER(FrameConstants, emitterEqualShare),
       MEMBER(FrameConstants, environmentProbability),
       MEMBER(FrameConstants, areaPowerShare),
       MEMBER(FrameConstants, areaEqualShare),
       MEMBER(FrameConstants, areaEnvironmentProbability),
       MEMBER(FrameConstants, environmentSize),
       MEMBER(FrameConstants, environmentCellSide),
       MEMBER(FrameConstants, environmentTurn),
       MEMBER(FrameConstants, pixelShare)},
      sizeof(shared::FrameConstants)}},
    {"LightData",
     {{MEMBER(LightData, position), MEMBER(LightData, intensity), MEMBER(LightData, direction), MEMBER(LightData, kind),
       MEMBER(LightData, colour), MEMBER(LightData, cosCutoff), MEMBER(LightData, cosBeam), MEMBER(LightData, depth),
       MEMBER(LightData, pathIndex), MEMBER(LightData, inverseRange)},
      sizeof(shared::LightData)}},
    {"VplGloss",
     {{MEMBER(VplGloss, flux), MEMBER(VplGloss, alpha), MEMBER(VplGloss, incoming), MEMBER(VplGloss, f90),
       MEMBER(VplGloss, normal), MEMBER(VplGloss, unused0), MEMBER(VplGloss, diffuse), MEMBER(VplGloss, unused1),
       MEMBER(VplGloss, f0), MEMBER(VplGloss, unused2)},
      sizeof(shared::VplGloss)}},
    {"Ray",
     {{MEMBER(Ray, origin), MEMBER(Ray, isAlive), MEMBER(Ray, direction), MEMBER(Ray, depth), MEMBER(Ray, intensity),
       MEMBER(Ray, inverseRange), MEMBER(Ray, normal), MEMBER(Ray, unused2)},
      sizeof(shared::Ray)}},
    {"Material",
     {{MEMBER(Material, albedo), MEMBER(Material, albedoTexture), MEMBER(Material, emittedRadiance),
       MEMBER(Material, emissionTexture), MEMBER(Material, specular), MEMBER(Material, metallic),
       MEMBER(Material, roughness), MEMBER(Material, metallicRoughnessTexture), MEMBER(Material, normalTexture),
       MEMBER(Material, normalScale), MEMBER(Material, alphaMode), MEMBER(Material, opacity),
       MEMBER(Material, alphaCutoff), MEMBER(Material, opacityTexture), MEMBER(Material, meanEmission),
       MEMBER(Material, isUnlit), MEMBER(Material, isCulled), MEMBER(Material, unused1)},
      sizeof(shared::Material)}},
    {"TextureInfo",
     {{MEMBER(TextureInfo, firstTexel), MEMBER(TextureInfo, width), MEMBER(TextureInfo, height),
       MEMBER(TextureInfo, mode), MEMBER(TextureInfo, uvMatrix), MEMBER(TextureInfo, uvOffset),
       MEMBER(TextureInfo, firstReduced), MEMBER(TextureInfo, levelCount)},
      sizeof(shared::TextureInfo)}},
    {"FrameStatus",
     {{MEMBER(FrameStatus, loopBudgetExceeded), MEMBER(FrameStatus, shadingNormalsCapped),
       MEMBER(FrameStatus, pathsTruncated), MEMBER(FrameStatus, vplsTraced), MEMBER(FrameStatus, vplsShaded)},
      sizeof(shared::FrameStatus)}},
    {"PathState",
     {{MEMBER(PathState, origin), MEMBER(PathState, isAlive), MEMBER(PathState, direction), MEMBER(PathState, density),
       MEMBER(PathState, throughput), MEMBER(PathState, scatterings), MEMBER(PathState, normal),
       MEMBER(PathState, unused), MEMBER(PathState, radiance), MEMBER(PathState, unused2)},
      sizeof(shared::PathState)}},
    {"PathTracePush",
     {{MEMBER(PathTracePush, firstRow), MEMBER(PathTracePush, endRow), MEMBER(PathTracePush, minScatterings),
       MEMBER(PathTracePush, maxScatterings), MEMBER(PathTracePush, russianRoulette), MEMBER(PathTracePush, jitter)},
      sizeof(shared::PathTracePush)}},
    {"RayHit", {{MEMBER(RayHit, t), MEMBER(RayHit, triangle), MEMBER(RayHit, barycentrics)}, sizeof(shared::RayHit)}},
    {"TraceRaysPush",
     {{MEMBER(TraceRaysPush, firstRay), MEMBER(TraceRaysPush, endRay)}, sizeof(shared::TraceRaysPush)}},
    {"EmissionPush",
     {{MEMBER(EmissionPush, firstPath), MEMBER(EmissionPush, pathCount), MEMBER(EmissionPush, maxDepth),
       MEMBER(EmissionPush, firstVpl), MEMBER(EmissionPush, vplCount), MEMBER(EmissionPush, paddedVplCount),
       MEMBER(EmissionPush, russianRoulette)},
      sizeof(shared::EmissionPush)}},
    {"ShadePush",
     {{MEMBER(ShadePush, firstLight), MEMBER(ShadePush, lightCount), MEMBER(ShadePush, firstVpl),
       MEMBER(ShadePush, vplCount), MEMBER(ShadePush, showEmission), MEMBER(ShadePush, firstRow),
       MEMBER(ShadePush, firstGloss)},
      sizeof(shared::ShadePush)}},
    {"BlockPush", {{MEMBER(BlockPush, width), MEMBER(BlockPush, period)}, sizeof(shared::BlockPush)}},
    {"VisibilityPush",
     {{MEMBER(VisibilityPush, width), MEMBER(VisibilityPush, period), MEMBER(VisibilityPush, rays)},
      sizeof(shared::VisibilityPush)}},
    {"RemodulatePush",
     {{MEMBER(RemodulatePush, toLender), MEMBER(RemodulatePush, scale)}, sizeof(shared::RemodulatePush)}},
    {"AtrousPush", {{MEMBER(AtrousPush, spacing), MEMBER(AtrousPush, deviations)}, sizeof(shared::AtrousPush)}},
    {"ReprojectionPush",
     {{MEMBER(ReprojectionPush, origin), MEMBER(ReprojectionPush, frames), MEMBER(ReprojectionPush, right),
       MEMBER(ReprojectionPush, areaShare), MEMBER(ReprojectionPush, down), MEMBER(ReprojectionPush, sceneMoved),
       MEMBER(ReprojectionPush, forward), MEMBER(ReprojectionPush, size)},
      sizeof(shared::ReprojectionPush)}},
    {"TemporalPush", {{MEMBER(TemporalPush, frames)}, sizeof(shared::TemporalPush)}},
    {"VisibilityRaysPush",
     {{MEMBER(VisibilityRaysPush, firstRow), MEMBER(VisibilityRaysPush, endRow)}, sizeof(shared::VisibilityRaysPush)}},
    {"ResamplePush",
     {{MEMBER(ResamplePush, interleave), MEMBER(ResamplePush, phase), MEMBER(ResamplePush, firstVpl),
       MEMBER(ResamplePush, endVpl), MEMBER(ResamplePush, firstTileRow), MEMBER(ResamplePush, tilesAcross),
       MEMBER(ResamplePush, tilesDown), MEMBER(ResamplePush, gridStart)},
      sizeof(shared::ResamplePush)}},
    {"TonemapPush", {{MEMBER(TonemapPush, scale), MEMBER(TonemapPush, curve)}, sizeof(shared::TonemapPush)}},
    {"ShowPush", {{MEMBER(ShowPush, channel), MEMBER(ShowPush, depthScale)}, sizeof(shared::ShowPush)}},
    {"ShowVplsPush", {{MEMBER(ShowVplsPush, radius), MEMBER(ShowVplsPush, brightness)}, sizeof(shared::ShowVplsPush)}},
    {"ShowRaysPush",
     {{MEMBER(ShowRaysPush, firstVpl), MEMBER(ShowRaysPush, endVpl), MEMBER(ShowRaysPush, vplCount),
       MEMBER(ShowRaysPush, shadowRays), MEMBER(ShowRaysPush, interleave), MEMBER(ShowRaysPush, phase),
       MEMBER(ShowRaysPush, firstRow), MEMBER(ShowRaysPush, gatherStep), MEMBER(ShowRaysPush, gridStart)},
      sizeof(shared::ShowRaysPush)}},
    {"WindowPicturePush",
     {{MEMBER(WindowPicturePush, size), MEMBER(WindowPicturePush, otherSize), MEMBER(WindowPicturePush, canvas),
       MEMBER(WindowPicturePush, divider), MEMBER(WindowPicturePush, tile)},
      sizeof(shared::WindowPicturePush)}},
    {"WindowPanelPush",
     {{MEMBER(WindowPanelPush, clip), MEMBER(WindowPanelPush, origin), MEMBER(WindowPanelPush, scale),
       MEMBER(WindowPanelPush, canvas), MEMBER(WindowPanelPush, atlas), MEMBER(WindowPanelPush, firstIndex)},
      sizeof(shared::WindowPanelPush)}},
    {"PanelVertex",
     {{MEMBER(PanelVertex, position), MEMBER(PanelVertex, uv), MEMBER(PanelVertex, rgba)},
      sizeof(shared::PanelVertex)}},
};

TEST(StructLayout, ShadersAndCppAgree) {
    std::set<std::string> seen;
    for (const std::string_view shader : gpu::shaderNames()) {
        SCOPED_TRACE(shader);
        const test::SpirvLayout layout = test::readSpirvLayout(gpu::shaderCode(shader));
        for (const auto& [name, expected] : kStructs) {
            const auto found = layout.offsets.find(name);
            if (found == layout.offsets.end()) continue;
            seen.insert(name);
            EXPECT_EQ(found->second, expected.offsets) << name;
            const auto stride = layout.strides.find(name);
            if (stride != layout.strides.end()) {
                EXPECT_EQ(stride->second, expected.size) << name;
            }
        }
    }
    for (const auto& [name, expected] : kStructs) EXPECT_TRUE(seen.contains(name)) << name << " is in no shader";
}

TEST(StructLayout, EveryStructInABufferIsKnown) {
    // A block that only wraps one array or one struct has a single member at offset 0: nothing to disagree about.
    for (const std::string_view shader : gpu::shaderNames())
        for (const auto& [name, offsets] : test::readSpirvLayout(gpu::shaderCode(shader)).offsets)
            if (offsets.size() > 1) {
                EXPECT_TRUE(kStructs.contains(name)) << name << " of " << shader << " is compared with nothing";
            }
}

}  // namespace
}  // namespace manylight
