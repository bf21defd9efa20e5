#include "engine/techniques/renderer.h"

#include "engine/core/check.h"
#include "engine/gpu/tuning_file.h"
#include "engine/graph/dump.h"
#include "engine/graph/finite_check.h"
#include "engine/math/projection.h"
#include "engine/passes/accumulate.h"
#include "engine/passes/show_vpls.h"
#include "engine/passes/tonemap.h"
#include "engine/passes/vpl_emission.h"
#include "engine/scene/diffuse_only.h"
#include "engine/techniques/forward_radiosity.h"
#include "engine/techniques/instant_radiosity.h"
#include "engine/techniques/lights_of_frame.h"
#include "engine/techniques/path_tracing.h"
#include "engine/techniques/plan_rays.h"
#include "engine/techniques/reconstruction.h"
#include "shaders/shared/frame.h"
#include "shaders/shared/sobol.h"
#include "shaders/shared/vpl_emission.h"
#include "shaders/shared/vpl_light.h"

#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>

namespace manylight {
namespace {

constexpr uint32_t kMostLightsOfPoints =
    8;                               // without noise: beyond, asking all at every point costs more than it gives
constexpr float kNearPlane = 1e-5f;  // of scenes whose diagonal is in [1, 2)

PhysicalBuffer makeFrameConstants(gpu::Device& device) {
    return {gpu::Buffer(device, "frame constants",
                        {sizeof(shared::FrameConstants), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, gpu::MemoryKind::Upload}),
            {}};
}

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Bvh buildTimed(const Scene& scene, double& seconds) {
    const auto start = std::chrono::steady_clock::now();
    Bvh bvh = buildBvh(scene);
    seconds = secondsSince(start);
    return bvh;
}

ScenePlan planFor(const gpu::Device& device, const Scene& scene, const RenderSettings& settings) {
    ScenePlan plan = planScene(scene, !settings.plan, settings.planKeeps);
    planRays(plan, settings.rays, rayAbilities(device));
    return plan;
}

GpuScene uploadTimed(gpu::Device& device, const Scene& scene, const ScenePlan& plan, const Bvh& bvh, double& seconds) {
    const auto start = std::chrono::steady_clock::now();
    GpuScene gpuScene = uploadScene(device, scene, plan, bvh);
    seconds = secondsSince(start);
    return gpuScene;
}

/// c N^(2/3) / A: the bias of the cut energy falls as fast as the variance it saves grows. What is given back causes no
/// bias, and c / A keeps the variance finite.
float geometryBound(const RenderSettings& settings, double litArea, uint32_t frameCount) {
    if (settings.clamp == ClampMode::Off || litArea <= 0.0) return std::numeric_limits<float>::max();
    const double paths = static_cast<double>(settings.pathCount) * (frameCount + 1);
    const double growth = settings.clamp == ClampMode::Compensate ? 1.0 : std::pow(paths, 2.0 / 3.0);
    return static_cast<float>(double{settings.clampBound.value_or(0.0f)} * growth / litArea);
}

uint32_t toneCurveOf(ToneCurve curve) {
    switch (curve) {
        case ToneCurve::Linear:
            return shared::kToneLinear;
        case ToneCurve::Reinhard:
            return shared::kToneReinhard;
        case ToneCurve::Aces:
            break;
    }
    return shared::kToneAces;
}

/// Whether pictures of both have the same mean. Numbers of samples and pixels are not asked.
bool meansTheSame(const RenderSettings& a, RenderSettings b) {
    b.camera = a.camera;
    b.width = a.width;
    b.height = a.height;
    b.vplCount = a.vplCount;
    b.pathCount = a.pathCount;
    b.lightSampleCount = a.lightSampleCount;
    b.jitter = a.jitter;
    b.exposure = a.exposure;
    b.toneCurve = a.toneCurve;
    return a == b;
}

/// A channel of the G-buffer instead of light.
bool showsChannel(Show show) { return show != Show::Picture && show != Show::Vpls && show != Show::CutOff; }

TechniqueResult declareTechnique(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs) {
    if (showsChannel(inputs.settings.show)) return declareInstantRadiosity(graph, scene, inputs);
    switch (inputs.settings.technique) {
        case Technique::Forward:
        case Technique::ForwardPrepass:
            return declareForwardRadiosity(graph, scene, inputs);
        case Technique::PathTracer:
            return declarePathTracing(graph, scene, inputs);
        case Technique::Deferred:
            break;
    }
    return declareInstantRadiosity(graph, scene, inputs);
}

}  // namespace

Renderer::Renderer(gpu::Device& device, const Scene& scene, const RenderSettings& settings,
                   gpu::PipelineLibrary* pipelines)
    : device_(device),
      givenScene_(scene),
      reducedScene_(settings.materials == Materials::Diffuse ? std::optional(diffuseOnly(scene)) : std::nullopt),
      scene_(reducedScene_ ? *reducedScene_ : scene),
      plan_(planFor(device, scene_, settings)),
      gpuScene_(uploadTimed(device, scene_, plan_, buildTimed(scene_, startupTimes_.bvhBuild), startupTimes_.upload)),
      ownPipelines_(pipelines == nullptr ? std::make_unique<gpu::PipelineLibrary>(device) : nullptr),
      pipelines_(pipelines == nullptr ? *ownPipelines_ : *pipelines),
      executor_(device, pipelines_),
      frameConstants_(makeFrameConstants(device)),
      statusBuffer_(makeStatusBuffer(device)),
      keepsVariance_(plan_.pixelVariance),
      keepsDisplay_(plan_.display) {
    setTuning(gpu::tuningOf(device, warnings_));
    executor_.setTreeDepth(gpuScene_.treeDepth);
    resolve(settings);
    if (isTemporal()) temporal_.makeRoom(device_, settings_.width, settings_.height);
    makeTargets();
}

Renderer::~Renderer() = default;

void Renderer::restart(const RenderSettings& settings) {
    if (settings.materials != settings_.materials)
        failUsage("--materials {}: expected the same for all pictures of one run", name(settings.materials));
    if (settings.rays != settings_.rays)
        failUsage("--rays {}: expected the same for all pictures of one run", name(settings.rays));
    const RenderSettings before = settings_;
    if (settings.camera != settings_.camera) isCameraGiven_ = false;
    resolve(settings);
    if (!meansTheSame(before, settings_)) temporal_ = {};
    if (isTemporal()) temporal_.makeRoom(device_, settings_.width, settings_.height);
    if (before.width != settings_.width || before.height != settings_.height) {
        makeTargets();
        gatherTuner_ = {};
    }
    frameCount_ = 0;
}

void Renderer::lookThrough(const Camera& camera) {
    camera_ = camera;
    isCameraGiven_ = true;
    frameCount_ = 0;
}

void Renderer::planAgain() {
    plan_ = planFor(device_, scene_, settings_);
    settle(plan_, kPlanPixelVariance, keepsVariance_);
    settle(plan_, kPlanCutOff, keepsCutOff_ || plan_.cutOff);
    settle(plan_, kPlanDisplay, keepsDisplay_);
}

void Renderer::relight(const Scene& scene) {
    if (reducedScene_) {
        reducedScene_->lights = scene.lights;
        for (size_t i = 0; i < scene.materials.size(); ++i)
            reducedScene_->materials[i].emittedRadiance = scene.materials[i].emittedRadiance;
    }
    MANYLIGHT_CHECK(scene_.triangles.size() == scene.triangles.size(), "relight() with another scene");
    planAgain();
    chooseGBuffer();
    replaceEmitters(device_, gpuScene_, scene_, plan_);
    frameCount_ = 0;
    forgetHistory();
    litArea_.reset();
    if (settings_.clamp != ClampMode::Off) measureLitArea();
}

void Renderer::setDisplay(float exposure, ToneCurve curve) {
    const bool isNew = exposure != settings_.exposure || curve != settings_.toneCurve;
    settings_.exposure = exposure;
    settings_.toneCurve = curve;
    if (isNew && keepsDisplay_ && frameCount_ > 0) makeDisplay();
}

void Renderer::makeDisplay() {
    FrameGraph graph;
    const SceneHandles scene = importScene(graph, gpuScene_, frameConstants_, statusBuffer_);
    const ImageHandle sum = isTemporal() ? temporal_.shown(graph) : radiance_.sum(graph);
    graph.keep(declareDisplay(graph, scene, sum, frameCount_));
    executor_.execute(graph);
}

void Renderer::sceneMoved(const RenderSettings& settings) {
    if (reducedScene_) {
        reducedScene_->instances = givenScene_.instances;
        reducedScene_->lights = givenScene_.lights;
        reducedScene_->cameras = givenScene_.cameras;
        reducedScene_->boundsMin = givenScene_.boundsMin;
        reducedScene_->boundsMax = givenScene_.boundsMax;
    }
    planAgain();
    moveInstances(device_, gpuScene_, scene_, plan_);
    litArea_.reset();
    temporal_.sceneMoved();
    restart(settings);
}

void Renderer::sceneReplaced(const RenderSettings& settings) {
    if (reducedScene_) *reducedScene_ = diffuseOnly(givenScene_);
    planAgain();
    const Bvh bvh = buildTimed(scene_, startupTimes_.bvhBuild);
    gpuScene_ = GpuScene{};  // before the new one, for its memory
    gpuScene_ = uploadTimed(device_, scene_, plan_, bvh, startupTimes_.upload);
    executor_.setTreeDepth(gpuScene_.treeDepth);
    gatherTuner_ = {};
    litArea_.reset();
    forgetHistory();
    restart(settings);
}

void Renderer::makeTargets() {
    const uint32_t width = settings_.width;
    const uint32_t height = settings_.height;
    display_ = {};
    radiance_ = {};
    cutOff_ = {};
    radiance_ = Accumulator(device_, "radiance", width, height, keepsVariance_);
    if (keepsCutOff_ || plan_.cutOff) cutOff_ = Accumulator(device_, "cut off", width, height, false);
    if (keepsDisplay_) makeDisplayTarget();
}

void Renderer::makeDisplayTarget() {
    constexpr VkImageUsageFlags kUsage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    display_.texture =
        gpu::Texture(device_, "display", {VK_FORMAT_R8G8B8A8_UNORM, settings_.width, settings_.height, kUsage});
}

ViewAxes Renderer::view() const {
    const float aspect = static_cast<float>(settings_.width) / static_cast<float>(settings_.height);
    return viewAxes(camera_.origin, camera_.forward, camera_.up, camera_.verticalFov, aspect);
}

/// The first frame of a view goes on where those of earlier views ended, or they would all have the same light paths.
uint32_t Renderer::numberInSequence() const {
    return isTemporal() && frameCount_ == 0 ? temporal_.framesBefore(view()) : frameCount_;
}

uint32_t Renderer::pointCount() const {
    const bool borrows = settings_.technique == Technique::Deferred && filters(settings_);
    const bool hasFewLights = gpuScene_.emitterTable.deltaLightCount <= kMostLightsOfPoints;
    return borrows && hasFewLights ? visibilitySamples(settings_.visibilitySamples, frameCount_) : 1;
}

glm::vec2 Renderer::offsetOfPoint(uint32_t point, uint32_t number, uint32_t seed) const {
    return shared::owenScrambledSobol2d(numberOfPoint(pointCount(), number, point), seed);
}

void Renderer::writeFrameConstants() {
    const ViewAxes view = this->view();
    const uint32_t frameNumber = numberInSequence();
    const uint32_t seed =
        settings_.continuesSequences ? settings_.seed : shared::hashCombine(settings_.seed, frameNumber);
    const uint32_t number = settings_.continuesSequences ? frameNumber : 0;  // of the frame in its sequences
    const glm::vec2 offset = settings_.jitter ? offsetOfPoint(0, number, seed) : glm::vec2(0.5f);
    const glm::vec2 size{settings_.width, settings_.height};
    const EmitterTable& table = gpuScene_.emitterTable;
    const bool local = settings_.lighting != Lighting::Global;

    shared::FrameConstants frame{};
    frame.clipFromWorld = clipFromWorld(view, kNearPlane, 2.0f * (glm::vec2(0.5f) - offset) / size);
    frame.cameraPosition = view.origin;
    frame.seed = seed;
    frame.cameraRight = view.right;
    frame.frame = number;
    frame.cameraDown = view.down;
    frame.emitterCount = static_cast<uint32_t>(table.emitters.size());
    frame.cameraForward = view.forward;
    frame.deltaLightCount = local ? table.deltaLightCount : 0;
    frame.imageSize = {settings_.width, settings_.height};
    frame.pixelOffset = offset;
    frame.sceneCenter = gpuScene_.sphere.center;
    frame.sceneRadius = gpuScene_.sphere.radius;
    frame.environmentRadiance = table.environmentRadiance;
    frame.geometryBound = geometryBound(settings_, litArea_.value_or(0.0), frameCount_);
    frame.pathCount = settings_.pathCount;
    frame.vplCount = settings_.vplCount;
    frame.lightSampleCount = local && plan_.areaLights && table.areaLightCount > 0
                                 ? lightSamplesOfPoint(settings_.lightSampleCount, pointCount())
                                 : 0;
    frame.triangleCount = gpuScene_.triangleCount;
    frame.bounceCount = static_cast<uint32_t>(*settings_.bounceCount);
    frame.emitterPowerShare = static_cast<float>(table.powerShare);
    frame.emitterEqualShare = static_cast<float>(table.equalShare);
    frame.environmentProbability = static_cast<float>(table.environmentProbability);
    frame.areaPowerShare = static_cast<float>(table.areaPowerShare);
    frame.areaEqualShare = static_cast<float>(table.areaEqualShare);
    frame.areaEnvironmentProbability = static_cast<float>(table.areaEnvironmentProbability);
    frame.environmentSize = gpuScene_.environmentSize;
    frame.environmentCellSide = gpuScene_.environmentCellSide;
    frame.environmentTurn = gpuScene_.environmentTurn;
    // Samples that move inside the pixel average it themselves.
    const float points = static_cast<float>(pointCount());
    frame.pixelShare = 1.0f / (settings_.jitter ? points * static_cast<float>(frameCount_ + 1) : points);
    std::memcpy(frameConstants_.buffer.mapped(), &frame, sizeof(frame));
    writeConstantsOfPoints(frame);
}

void Renderer::writeConstantsOfPoints(const shared::FrameConstants& first) {
    const uint32_t further = pointCount() - 1;
    pixelOffsets_ = {first.pixelOffset};
    while (constantsOfPoints_.size() < further) constantsOfPoints_.push_back(makeFrameConstants(device_));
    for (uint32_t i = 0; i < further; ++i) {
        shared::FrameConstants frame = first;
        frame.seed = shared::hashCombine(first.seed,
                                         i + 1);  // of samples of lights, and surfaces that let rays through by chance
        frame.pixelOffset = offsetOfPoint(i + 1, first.frame, first.seed);
        frame.clipFromWorld = clipFromWorld(view(), kNearPlane,
                                            2.0f * (glm::vec2(0.5f) - frame.pixelOffset) / glm::vec2(frame.imageSize));
        pixelOffsets_.push_back(frame.pixelOffset);
        std::memcpy(constantsOfPoints_[i].buffer.mapped(), &frame, sizeof(frame));
    }
}

std::vector<SeenPoint> Renderer::seenPoints(FrameGraph& graph, const SceneHandles& scene) {
    std::vector<SeenPoint> points = {{scene.frame, pixelOffsets_[0]}};
    for (uint32_t i = 1; i < pixelOffsets_.size(); ++i)
        points.push_back({importPhysical(graph, "frame constants", constantsOfPoints_[i - 1]), pixelOffsets_[i]});
    return points;
}

ImageHandle Renderer::declareDisplay(FrameGraph& graph, const SceneHandles& scene, ImageHandle sum,
                                     uint32_t frameCount) {
    const float scale = std::exp2(settings_.exposure) / static_cast<float>(frameCount);
    const ToneCurve curve = showsChannel(settings_.show) ? ToneCurve::Linear : settings_.toneCurve;
    return addTonemap(graph, scene, sum, importPhysical(graph, "display", display_), scale, toneCurveOf(curve),
                      settings_.width, settings_.height);
}

FrameGraph Renderer::declareFrame() {
    FrameGraph graph;
    SceneHandles scene = importScene(graph, gpuScene_, frameConstants_, statusBuffer_);
    addStatusReset(graph, scene);

    const uint32_t tuned = tuning().pixelsPerInvocation;
    RenderSettings settings = settings_;
    settings.interleavePhase += numberInSequence() - frameCount_;
    const FrameInputs inputs{.settings = settings,
                             .plan = plan_,
                             .gpuScene = gpuScene_,
                             .frame = frameCount_,
                             .subgroupSize = device_.subgroupSize(),
                             .pixelsPerInvocation = tuned > 0 ? tuned : gatherTuner_.pixelsPerInvocation(),
                             .points = seenPoints(graph, scene),
                             .environmentRadiance = gpuScene_.emitterTable.environmentRadiance,
                             .gbufferByRays = gbufferByRays_,
                             .keepsCutOff = keepsCutOff_ || plan_.cutOff || settings_.show == Show::CutOff};
    TechniqueResult result = declareTechnique(graph, scene, inputs);
    if (settings_.show == Show::Vpls && result.vpls && result.depth)
        result.radiance = addShowVpls(graph, scene, *result.vpls, settings_.vplCount, result.radiance, *result.depth,
                                      settings_.vplDotRadius, 1.0f);
    if (settings_.show == Show::CutOff) result.radiance = *result.cutOff;
    if (keepsVpls_ && result.vpls) {
        if (vplCopy_.buffer.size() != paddedVplCount(settings_.vplCount) * sizeof(shared::LightData))
            vplCopy_ = makeVplCopy(device_, settings_.vplCount);
        copyVplsToHost(graph, *result.vpls, vplCopy_);
    }

    ImageHandle sum = radiance_.add(graph, scene, result.radiance, frameCount_);
    if (isTemporal()) sum = temporal_.add(graph, scene, plan_, *result.gbuffer, result.radiance, sum, frameCount_);
    if (cutOff_.exists() && result.cutOff) cutOff_.add(graph, scene, *result.cutOff, frameCount_);
    graph.keep(keepsDisplay_ ? declareDisplay(graph, scene, sum, frameCount_ + 1) : sum);
    addStatusReadback(graph, scene);
    return graph;
}

Execution Renderer::renderFrame() {
    writeFrameConstants();
    const FrameGraph graph = declareFrame();
    if (settings_.checkFinite) executor_.dumpAfter(GraphExecutor::kAllPasses);
    Execution execution = executor_.execute(graph);
    if (settings_.checkFinite) refuseNonFinite(execution);
    tuneGather(execution);
    status_ = readStatus(statusBuffer_);
    if (status_.loopBudgetExceeded != 0)
        fail(
            "device {} ended a ray before its time (its loop limit was met): the picture would be wrong. "
            "Fewer bounces, or a scene with a shallower BVH, may help",
            device_.info().name);
    if (isUnlimited_) warnings_.add("light paths cut off at the depth limit", {}, status_.pathsTruncated);
    warnings_.add("light-path vertices whose shading-normal correction met its bound", {},
                  status_.shadingNormalsCapped);
    ++frameCount_;
    if (isTemporal()) temporal_.finishFrame(view(), frameCount_);
    return execution;
}

void Renderer::refuseNonFinite(const Execution& execution) const {
    if (const auto found = findNonFinite(execution.dumped))
        fail("frame {}: pass {} wrote {} texel(s) of '{}' that are not finite, the first at ({}, {})", frameCount_,
             found->pass, found->texels, found->resource, found->x, found->y);
}

void Renderer::tuneGather(const Execution& execution) {
    if (settings_.technique != Technique::Deferred || settings_.castShadows || tuning().pixelsPerInvocation > 0) return;
    double milliseconds = 0.0;
    for (const PassTime& pass : execution.passTimes)
        if (pass.pass == "vpl_light") milliseconds += pass.milliseconds;
    if (milliseconds > 0.0) gatherTuner_.report(milliseconds);
}

void Renderer::keepVariance(bool keeps) {
    keepsVariance_ = keeps || plan_.pixelVariance;
    settle(plan_, kPlanPixelVariance, keepsVariance_);
    makeTargets();
    frameCount_ = 0;
}

void Renderer::keepCutOff(bool keeps) {
    if (keeps && settings_.technique != Technique::Deferred)
        failUsage("what the bound cuts off is known to --technique deferred only");
    keepsCutOff_ = keeps;
    settle(plan_, kPlanCutOff, keeps || plan_.cutOff);
    makeTargets();
    frameCount_ = 0;
}

Image Renderer::radiance() {
    return isTemporal() ? temporal_.mean(device_, frameCount_) : radiance_.mean(device_, frameCount_);
}

Image Renderer::varianceOfMean() { return radiance_.varianceOfMean(device_, frameCount_); }

Image Renderer::cutOff() { return cutOff_.mean(device_, frameCount_); }

double Renderer::relativeStandardError() {
    double sum = 0.0;
    for (const float value : radiance().texels) sum += double{value};
    double squares = 0.0;
    const Image variance = varianceOfMean();
    for (const float value : variance.texels) squares += double{value};
    const auto count = static_cast<double>(variance.texels.size());
    return sum > 0.0 ? std::sqrt(squares / count) / (sum / count) : 0.0;
}

void Renderer::keepDisplay() {
    if (!display_.texture.exists()) makeDisplayTarget();
    keepsDisplay_ = true;
    settle(plan_, kPlanDisplay, true);
}

PhysicalImage& Renderer::display() {
    if (keepsDisplay_) return display_;
    MANYLIGHT_CHECK(frameCount_ > 0u, "display()");
    if (!display_.texture.exists()) makeDisplayTarget();
    makeDisplay();
    return display_;
}

std::vector<uint8_t> Renderer::displayRgba() {
    const std::vector<std::byte> bytes = readPhysical(device_, display());
    std::vector<uint8_t> rgba(bytes.size());
    std::memcpy(rgba.data(), bytes.data(), bytes.size());
    return rgba;
}

std::vector<shared::LightData> Renderer::vpls() const {
    MANYLIGHT_CHECK(vplCopy_.buffer.exists(), "vpls() before keepVpls() and a frame");
    std::vector<shared::LightData> list(settings_.vplCount);
    std::memcpy(list.data(), vplCopy_.buffer.mapped(), list.size() * sizeof(shared::LightData));
    return list;
}

Renderer::GraphDump Renderer::dumpGraph() {
    writeFrameConstants();
    const FrameGraph graph = declareFrame();
    const CompiledGraph compiled = graph.compile([](const PhysicalSlot&) { return ResourceState{}; });
    return {toDot(graph, compiled), toJson(graph, compiled), toText(graph, compiled)};
}

}  // namespace manylight
