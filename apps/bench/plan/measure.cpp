#include "apps/bench/plan/measure.h"

#include "apps/bench/calibration.h"
#include "apps/common/interrupt.h"
#include "engine/core/progress.h"
#include "engine/scene/import.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <memory>
#include <numeric>
#include <random>

namespace manylight {
namespace {

using Clock = std::chrono::steady_clock;

/// What a variant asks of the plan.
RenderSettings withPlan(RenderSettings settings, bool plan, const std::string& keeps) {
    settings.plan = plan;
    settings.planKeeps = keeps;
    return settings;
}

/// As planned, each thing that was left out kept alone (of `decisions`, if any), as planned once more, everything kept.
std::vector<std::pair<PlanVariant, RenderSettings>> variantsOf(const ScenePlan& plan, const RenderSettings& settings,
                                                               const std::vector<std::string>& decisions) {
    const auto isAskedFor = [&](const PlanDecision& decision) {
        return decisions.empty() || std::ranges::find(decisions, decision.what) != decisions.end();
    };
    std::vector<std::pair<PlanVariant, RenderSettings>> variants;
    const auto add = [&](const std::string& name, const std::string& reason, const RenderSettings& ofVariant) {
        PlanVariant variant;
        variant.name = name;
        variant.reason = reason;
        variants.emplace_back(std::move(variant), ofVariant);
    };
    add("as planned", "", withPlan(settings, true, ""));
    for (const PlanDecision& decision : plan.decisions)
        if (decision.leftOut && decision.canBeKept && isAskedFor(decision))
            add(decision.what, decision.reason, withPlan(settings, true, decision.what));
    add(kPlannedAgain, "", withPlan(settings, true, ""));
    add("--plan off", "nothing is left out", withPlan(settings, false, ""));
    return variants;
}

void addTimes(PlanVariant& variant, const Execution& execution) {
    variant.gpuMilliseconds.push_back(execution.gpuMilliseconds);
    const size_t count = variant.gpuMilliseconds.size();
    for (const PassTime& time : execution.passTimes) {
        auto pass = std::ranges::find_if(variant.passes, [&](const auto& known) { return known.first == time.pass; });
        if (pass == variant.passes.end()) pass = variant.passes.insert(pass, {time.pass, {}});
        pass->second.resize(count);
        pass->second.back() += time.milliseconds;
    }
}

PictureDifference differenceOf(const Image& picture, const Image& planned) {
    const size_t bytes = planned.texels.size() * sizeof(float);
    PictureDifference result;
    result.sameBytes = picture.texels.size() == planned.texels.size() &&
                       std::memcmp(picture.texels.data(), planned.texels.data(), bytes) == 0;
    double difference = 0.0;
    double sum = 0.0;
    for (size_t i = 0; i < planned.texels.size(); ++i) {
        difference += std::abs(double{picture.texels[i]} - double{planned.texels[i]});
        sum += double{planned.texels[i]};
    }
    result.relative = difference == 0.0 ? 0.0 : difference / sum;
    return result;
}

size_t passesUnlike(const PlanVariant& a, const PlanVariant& b) {
    const auto missing = [](const PlanVariant& from, const PlanVariant& in) {
        return std::ranges::count_if(from.passes, [&](const auto& pass) {
            return std::ranges::none_of(in.passes, [&](const auto& other) { return other.first == pass.first; });
        });
    };
    return static_cast<size_t>(missing(a, b) + missing(b, a));
}

void askForAllOutputs(Renderer& renderer) {
    renderer.keepVariance(true);
    if (renderer.settings().technique == Technique::Deferred) renderer.keepCutOff(true);
    renderer.keepDisplay();
}

/// A renderer and its first frame, twice: the first start fills the caches of pipelines, the second is timed.
std::unique_ptr<Renderer> start(gpu::Device& device, const Scene& scene, const RenderSettings& settings,
                                bool wantsAllOutputs, PlanVariant& variant) {
    std::unique_ptr<Renderer> renderer;
    for (int turn = 0; turn < 2; ++turn) {
        renderer.reset();
        const VkDeviceSize before = device.allocator().bytesInUse();
        const auto begin = Clock::now();
        renderer = std::make_unique<Renderer>(device, scene, settings);
        if (wantsAllOutputs) askForAllOutputs(*renderer);
        renderer->renderFrame();
        variant.startSeconds = std::chrono::duration<double>(Clock::now() - begin).count();
        variant.deviceBytes = device.allocator().bytesInUse() - before;
    }
    return renderer;
}

/// 0 to count - 1 in another order for every turn, so that none always follows the same other.
std::vector<size_t> shuffled(size_t count, uint32_t turn) {
    std::vector<size_t> order(count);
    std::iota(order.begin(), order.end(), size_t{0});
    std::ranges::shuffle(order, std::mt19937(turn));
    return order;
}

PlanScene measureScene(gpu::Device& device, const PlanOptions& options, const std::filesystem::path& file) {
    const Scene scene = importScene(file, {.instances = instanceModeFrom(options.instances)});
    printWarnings(scene.warnings);
    RenderSettings settings = resolveSettings(scene, options.settings);
    settings.jitter = options.frames > 1;
    PlanScene result;
    result.name = scene.name;
    result.file = file.filename().string();
    result.triangles = scene.triangles.size();

    const ScenePlan plan = planScene(scene);
    for (const std::string& decision : options.decisions) planScene(scene, false, decision);  // or says which there are
    auto variants = variantsOf(plan, settings, options.decisions);
    Progress progress("plan " + scene.name, variants.size() * (options.frames + 1));
    std::vector<std::unique_ptr<Renderer>> renderers;
    for (auto& [variant, ofVariant] : variants) {
        if (isInterrupted()) return result;
        renderers.push_back(start(device, scene, ofVariant, options.wantsAllOutputs, variant));
        progress.advance();
    }
    for (uint32_t frame = 0; frame < options.frames; ++frame)
        for (const size_t i : shuffled(variants.size(), frame)) {
            if (isInterrupted()) return result;
            addTimes(variants[i].first, renderers[i]->renderFrame());
            progress.advance();
        }

    result.settings = renderers.front()->settings();
    const Image planned = renderers.front()->radiance();
    for (size_t i = 0; i < variants.size(); ++i) {
        PlanVariant& variant = variants[i].first;
        variant.difference = differenceOf(renderers[i]->radiance(), planned);
        variant.pipelines = renderers[i]->pipelines().size();
        variant.pipelinesUnlikePlanned = renderers[i]->pipelines().differenceFrom(renderers.front()->pipelines());
        variant.passesUnlikePlanned =
            passesUnlike(variant, result.variants.empty() ? variant : result.variants.front());
        result.variants.push_back(std::move(variants[i].first));
    }
    return result;
}

}  // namespace

bool isSameWork(const PlanVariant& variant, const PlanVariant& planned) {
    return variant.pipelinesUnlikePlanned == 0 && variant.passesUnlikePlanned == 0 &&
           variant.deviceBytes == planned.deviceBytes && variant.difference.sameBytes;
}

PlanRun measurePlans(const PlanOptions& options) {
    const InterruptGuard guard;
    PlanRun run;
    gpu::Device device({.select = options.device});
    run.machine = describeMachine(device);
    for (const std::filesystem::path& file : options.scenes) {
        run.calibration.push_back(calibrationMilliseconds());
        PlanScene scene = measureScene(device, options, file);
        run.isInterrupted = isInterrupted();
        if (run.isInterrupted) break;
        run.scenes.push_back(std::move(scene));
    }
    run.calibration.push_back(calibrationMilliseconds());
    return run;
}

}  // namespace manylight
