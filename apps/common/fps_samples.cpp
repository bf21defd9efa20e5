#include "apps/common/fps_samples.h"

#include <algorithm>
#include <chrono>

namespace manylight {
namespace {

using Clock = std::chrono::steady_clock;

constexpr uint32_t kInterleave = 4;

void addPassTimes(std::vector<PassSamples>& passes, const std::vector<PassTime>& times) {
    for (PassSamples& pass : passes) pass.milliseconds.push_back(0.0);
    for (const PassTime& time : times) {
        auto pass =
            std::find_if(passes.begin(), passes.end(), [&](const auto& known) { return known.pass == time.pass; });
        if (pass == passes.end()) pass = passes.insert(passes.end(), {time.pass, {0.0}});
        pass->milliseconds.back() += time.milliseconds;
    }
}

Technique techniqueOf(FpsMethod method) {
    if (method == FpsMethod::Forward) return Technique::Forward;
    return method == FpsMethod::ForwardPrepass ? Technique::ForwardPrepass : Technique::Deferred;
}

}  // namespace

const char* name(FpsMethod method) {
    if (method == FpsMethod::Interleaved) return "interleaved";
    return method == FpsMethod::Filtered ? "filtered" : name(techniqueOf(method));
}

double measureFrame(Renderer& renderer, FpsSamples* samples) {
    const auto start = Clock::now();
    const Execution execution = renderer.renderFrame();
    const double total = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    if (samples != nullptr) {
        samples->wall.push_back(execution.wallMilliseconds);
        samples->host.push_back(total - execution.wallMilliseconds);
        samples->gpu.push_back(execution.gpuMilliseconds);
        samples->vplsShaded.push_back(renderer.status().vplsShaded);
        addPassTimes(samples->passes, execution.passTimes);
    }
    return execution.wallMilliseconds;
}

void restartFor(Renderer& renderer, RenderSettings settings, const FpsCell& cell) {
    settings.technique = techniqueOf(cell.method);
    settings.interleave = cell.method >= FpsMethod::Interleaved ? kInterleave : 1;
    settings.filter = cell.method == FpsMethod::Filtered ? Filter::Atrous : Filter::Off;
    settings.castShadows = cell.castShadows;
    settings.vplCount = cell.vplCount;
    settings.temporal = false;  // frames of one view owe nothing to others
    renderer.restart(settings);
}

}  // namespace manylight
