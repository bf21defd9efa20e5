#include "apps/bench/tune/workloads.h"

#include "apps/common/interrupt.h"

#include <algorithm>

namespace manylight {
namespace {

constexpr uint32_t kVplsWithRays = 32;  // of which each costs as much as hundreds without
constexpr uint32_t kFramesOfGatherTuner = 6;

RenderSettings settingsFor(Way way, const TuneOptions& options) {
    RenderSettings settings;
    applySetting(settings, "size", options.size);
    switch (way) {
        case Way::Gather:
            settings.castShadows = false;
            break;
        case Way::Shadows:
            settings.vplCount = kVplsWithRays;
            break;
        case Way::Draft:
            applySetting(settings, kPresetOption, name(Quality::Draft));
            break;
        case Way::Paths:
            settings.technique = Technique::PathTracer;
            break;
    }
    settings.jitter = false;
    return settings;
}

bool isReached(Way way, const TuneOptions& options) {
    return std::ranges::any_of(gpu::tunables(), [&](const gpu::Tunable& tunable) {
        const Reach reach = reachOf(tunable.name);
        return isAskedFor(options, tunable) && std::ranges::find(reach.ways, way) != reach.ways.end();
    });
}

}  // namespace

Reach reachOf(const std::string& tunable) {
    const Reach rays{{Way::Shadows, Way::Draft, Way::Paths}, {"vpl_light", "direct_light", "path_trace"}};
    if (tunable == "gather-threads" || tunable == "pixels-per-invocation") return {{Way::Gather}, {"vpl_light"}};
    if (tunable == "path-threads") return {{Way::Gather, Way::Draft}, {"vpl_emission", "vpl_bounce", "vpl_compact"}};
    if (tunable == "image-width" || tunable == "image-height")
        return {{Way::Draft}, {"gbuffer", "accumulate", "reconstruct", "remodulate", "background", "tonemap"}};
    if (tunable == "dispatch-parts") return {{Way::Gather, Way::Shadows}, {"vpl_light", "direct_light"}};
    if (tunable == "nodes-closest-hit" || tunable == "closest-in-registers")
        return {{Way::Draft, Way::Paths}, {"vpl_bounce", "path_trace"}};
    return rays;
}

bool isAskedFor(const TuneOptions& options, const gpu::Tunable& tunable) {
    return options.tunables.empty() || std::ranges::find(options.tunables, tunable.name) != options.tunables.end();
}

Workloads makeWorkloads(gpu::Device& device, const std::vector<Scene>& scenes, const TuneOptions& options) {
    Workloads workloads;
    for (const Scene& scene : scenes)
        for (const Way way : {Way::Gather, Way::Shadows, Way::Draft, Way::Paths}) {
            if (isInterrupted() || !isReached(way, options)) continue;
            Workload workload;
            workload.way = way;
            workload.renderer = std::make_unique<Renderer>(device, scene, settingsFor(way, options));
            workload.settings = workload.renderer->settings();
            // The default may try out: it does so now, and not while it is measured.
            const uint32_t frames = way == Way::Gather ? kFramesOfGatherTuner : 1;
            for (uint32_t frame = 0; frame < frames; ++frame) renderWith(workload, {});
            workloads.push_back(std::move(workload));
        }
    return workloads;
}

Execution renderWith(Workload& workload, const gpu::Tuning& tuning) {
    workload.renderer->setTuning(tuning);
    workload.renderer->restart(workload.settings);
    return workload.renderer->renderFrame();
}

double milliseconds(const Execution& execution, const Reach& reach) {
    double sum = 0.0;
    for (const PassTime& time : execution.passTimes)
        if (std::ranges::any_of(reach.passes, [&](const std::string& pass) { return time.pass.starts_with(pass); }))
            sum += time.milliseconds;
    return sum;
}

}  // namespace manylight
