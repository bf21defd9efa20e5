// What must agree exactly, to rounding, or in expectation.
#include "apps/bench/stability/families.h"
#include "apps/bench/stability/lab.h"
#include "apps/bench/stability/scenes.h"

#include <fmt/format.h>

namespace manylight::stability {

Findings repeated(StabilityLab& lab) {
    Findings findings;
    const Scene scene = normalise(furnishedRoom());
    for (const Technique technique :
         {Technique::Deferred, Technique::Forward, Technique::ForwardPrepass, Technique::PathTracer}) {
        const RenderSettings settings = withTechnique(stabilitySettings(24, 18), technique);
        const Image first = lab.render(scene, settings, 2);
        findings.push_back(sameBytes(fmt::format("{}, again", name(technique)), lab.render(scene, settings, 2), first));
        RenderSettings everything = settings;
        everything.plan = false;
        findings.push_back(
            sameBytes(fmt::format("{}, nothing left out", name(technique)), lab.render(scene, everything, 2), first));
    }
    return findings;
}

Findings techniquesAgree(StabilityLab& lab) {
    Findings findings;
    const Scene scene = normalise(furnishedRoom());
    for (const uint32_t vpls : {0u, 1u, 130u, 300u}) {
        RenderSettings settings = stabilitySettings(24, 18);
        settings.vplCount = vpls;
        const Image deferred = lab.render(scene, settings);
        for (const Technique technique : {Technique::Forward, Technique::ForwardPrepass})
            findings.push_back(closePictures(fmt::format("{} VPLs, {}, deferred", vpls, name(technique)),
                                             lab.render(scene, withTechnique(settings, technique)), deferred,
                                             1e-5));  // G-buffer: albedo in steps of 2^-21, rounded normals
    }
    return findings;
}

Findings estimatorsAgree(StabilityLab& lab) {
    const Scene scene = normalise(furnishedRoom());
    RenderSettings settings = stabilitySettings(12, 12);
    Renderer renderer(lab.device(), scene, settings, lab.pipelines());
    const std::vector<double> reference = lab.means(renderer, withTechnique(settings, Technique::PathTracer), 16, 32);
    Findings findings;
    const auto add = [&](const char* what, const RenderSettings& other, uint32_t frames) {
        // 2 %: a bounce more or less is 10 % of this picture and more.
        findings.push_back(
            meansAgree(fmt::format("{}, path tracer", what), lab.means(renderer, other, 16, frames), reference, 0.02));
    };
    add("deferred", settings, 8);
    add("compensated", withClamp(settings, ClampMode::Compensate), 8);
    add("forward", withTechnique(settings, Technique::Forward), 8);
    RenderSettings other = settings;
    other.bounceCount = 24;  // albedo 0.6 at most: what is beyond is 1e-5 of the light
    other.russianRoulette = false;
    other.pathCount = 10;  // the list takes all their vertices; a sample of equally long paths would be of few depths
    add("no roulette", other, 64);
    add("path tracer without roulette", withTechnique(other, Technique::PathTracer), 32);
    other = settings;
    other.vplCount = 37;
    add("37 VPLs", other, 32);
    other.pathCount = 1000;
    add("37 VPLs of 1000 paths", other, 32);
    return findings;
}

}  // namespace manylight::stability
