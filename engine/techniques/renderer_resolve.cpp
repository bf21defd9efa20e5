// What the settings of a user come to for a scene and a device.
#include "engine/core/check.h"
#include "engine/passes/vpl_emission.h"
#include "engine/techniques/lights_of_frame.h"
#include "engine/techniques/lit_area.h"
#include "engine/techniques/renderer.h"
#include "shaders/shared/vpl_emission.h"
#include "shaders/shared/vpl_light.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace manylight {
namespace {

// c of the two bounds. The vanishing one was measured on the Cornell box, as 10 relative to the area of all triangles,
// which is about 7 of what light reaches there; the other on that, Sponza and a classroom (docs/results.md).
constexpr float kVanishingBound = 7.0f;
constexpr float kCompensatedBound = 30.0f;

constexpr uint32_t kMostPaths = 1u << 21;  // that are taken without being asked for

// The paths that tell how large an area the light reaches: the same whatever is rendered.
constexpr uint32_t kPilotVpls = 1024;
constexpr int kPilotBounces = 8;

// Break-even on a software driver at 2: 0.28 us for a triangle drawn, 0.6 us for a pixel's ray.
constexpr uint64_t kTrianglesPerPixelForRays = 2;
constexpr const char* kRasteriser = "rasteriser";  // as the plan calls it

/// Where the share of light that goes on has fallen to 1e-5: ln 1e-5 / ln albedo, in a scene of one albedo.
uint32_t unlimitedBounces(float meanAlbedo) {
    if (meanAlbedo >= 1.0f) return kMaxBounces;
    const double bounces = std::ceil(std::log(1e-5) / std::log(std::max(double{meanAlbedo}, 1e-3)));
    return static_cast<uint32_t>(std::clamp(bounces, double{kUnlimitedBounces}, double{kMaxBounces}));
}

}  // namespace

void Renderer::resolve(const RenderSettings& settings) {
    MANYLIGHT_CHECK(!scene_.cameras.empty(), "scene {}", scene_.path.string());
    settings_ = settings;
    if (settings.camera >= scene_.cameras.size())
        failUsage("--camera {}: the scene has {} camera(s), counted from 0", settings.camera, scene_.cameras.size());
    if (!isCameraGiven_) camera_ = scene_.cameras[settings.camera];
    if (settings.width == 0 || settings.height == 0) {
        const glm::uvec2 size = camera_.resolution.value_or(glm::uvec2{512, 384});
        settings_.width = size.x;
        settings_.height = size.y;
    }
    if ((keepsCutOff_ || settings.show == Show::CutOff) && settings.technique != Technique::Deferred)
        failUsage("what the bound cuts off is known to --technique deferred only");
    const uint32_t limit = device_.limits().maxImageDimension2D;
    if (settings_.width > limit || settings_.height > limit)
        fail("--size {}x{}: device {} allows at most {}x{}", settings_.width, settings_.height, device_.info().name,
             limit, limit);
    const uint32_t mostVpls = device_.limits().maxTexelBufferElements / shared::kTexelsPerLight - shared::kVplPadding;
    if (settings.vplCount > mostVpls)
        fail("--vpls {}: device {} allows at most {} VPLs", settings.vplCount, device_.info().name, mostVpls);
    if (settings.clamp == ClampMode::Compensate && !settings.castShadows)
        failUsage("--clamp compensate: expected --shadows on; light that passes through walls cannot be compensated");
    const bool needsDeferred = settings.interleave > 1 || settings.shadowRays > 0 || settings.filter != Filter::Off;
    if (settings.technique != Technique::Deferred && needsDeferred)
        failUsage("--interleave, --shadow-rays and --filter: expected --technique deferred");
    if (settings.technique != Technique::Deferred && settings.temporal)
        failUsage("--temporal on: expected --technique deferred");
    if (settings.technique != Technique::Deferred && settings.gbuffer == GBufferBy::Rays)
        failUsage("--gbuffer rays: expected --technique deferred");
    if (settings.show == Show::Vpls && settings.gbuffer == GBufferBy::Rays)
        failUsage("--gbuffer rays: expected raster with --show vpls, whose discs need a depth");
    if (settings.technique == Technique::PathTracer && !settings.castShadows)
        failUsage("--technique path-tracer: expected --shadows on");
    if (!settings.clampBound)
        settings_.clampBound = settings.clamp == ClampMode::Compensate ? kCompensatedBound : kVanishingBound;
    const int depth = settings.bounceCount               ? *settings.bounceCount
                      : scene_.maxDepth.value_or(-1) < 0 ? -1
                                                         : std::max(0, *scene_.maxDepth - 2);
    isUnlimited_ = depth < 0;
    settings_.bounceCount = depth < 0 ? static_cast<int>(unlimitedBounces(gpuScene_.meanAlbedo)) : depth;
    const uint64_t mostPaths =
        uint64_t{settings_.vplCount} * pathsPerBatch(static_cast<uint32_t>(*settings_.bounceCount));
    if (settings.pathCount == 0)
        settings_.pathCount =
            static_cast<uint32_t>(std::min({defaultPathCount(settings.vplCount), mostPaths, uint64_t{kMostPaths}}));
    if (settings_.vplCount > 0 && settings_.pathCount > mostPaths)
        failUsage("--paths {}: expected at most {} for {} VPLs and {} bounces", settings_.pathCount, mostPaths,
                  settings_.vplCount, *settings_.bounceCount);
    chooseGBuffer();
    if (settings_.clamp != ClampMode::Off && !litArea_) measureLitArea();
}

void Renderer::chooseGBuffer() {
    std::erase_if(plan_.decisions, [](const PlanDecision& decision) { return decision.what == kRasteriser; });
    gbufferByRays_ = false;
    if (settings_.technique != Technique::Deferred) return;
    const uint64_t pixels = uint64_t{settings_.width} * settings_.height;
    const bool isCrowded = gpuScene_.triangleCount > kTrianglesPerPixelForRays * pixels;
    const std::string reason = fmt::format("{} triangles for {} pixels, --gbuffer {}", gpuScene_.triangleCount, pixels,
                                           name(settings_.gbuffer));
    gbufferByRays_ = settings_.gbuffer == GBufferBy::Auto ? isCrowded && settings_.show != Show::Vpls
                                                          : settings_.gbuffer == GBufferBy::Rays;
    plan_.decisions.push_back({.what = kRasteriser, .leftOut = gbufferByRays_, .reason = reason, .canBeKept = false});
}

void Renderer::measureLitArea() {
    const RenderSettings settings = settings_;
    settings_.seed = 0;
    settings_.vplCount = settings_.pathCount = kPilotVpls;
    settings_.bounceCount = kPilotBounces;
    settings_.lighting = Lighting::Global;
    settings_.russianRoulette = true;
    settings_.temporal = false;
    frameCount_ = 0;
    writeFrameConstants();

    PhysicalBuffer status = makeStatusBuffer(device_);
    FrameGraph graph;
    SceneHandles scene = importScene(graph, gpuScene_, frameConstants_, status);
    addStatusReset(graph, scene);
    const LightsOfFrame lights =
        addLightsOfFrame(graph, scene, {.settings = settings_, .plan = plan_, .gpuScene = gpuScene_});
    if (lights.vplCount > 0) {
        PhysicalBuffer copy = makeVplCopy(device_, kPilotVpls);
        copyVplsToHost(graph, lights.vpls.list, copy);
        executor_.execute(graph);
        litArea_ =
            manylight::litArea(std::span(static_cast<const shared::LightData*>(copy.buffer.mapped()), kPilotVpls));
    }
    if (!litArea_) litArea_ = gpuScene_.surfaceArea;
    settings_ = settings;
}

}  // namespace manylight
