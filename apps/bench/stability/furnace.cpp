// The white furnace: in a closed room whose walls all emit Le and reflect the share a, radiance is Le / (1 - a).
#include "apps/bench/stability/families.h"
#include "apps/bench/stability/lab.h"
#include "apps/bench/stability/scenes.h"

#include <fmt/format.h>

#include <cmath>

namespace manylight::stability {
namespace {

/// Emission, light samples, and VPLs of `bounces` depths: a + ... + a^(bounces + 1) times Le.
double truncatedFurnace(double albedo, int bounces) { return (1.0 - std::pow(albedo, bounces + 2)) / (1.0 - albedo); }

RenderSettings furnaceSettings(Technique technique) {
    RenderSettings settings = withTechnique(stabilitySettings(), technique);
    settings.clamp = technique == Technique::Deferred ? ClampMode::Compensate : ClampMode::Off;
    settings.vplCount = 512;
    settings.pathCount = 256;
    settings.lightSampleCount = 64;
    return settings;
}

void addFurnace(StabilityLab& lab, Findings& findings, double albedo) {
    const Scene scene = normalise(closedRoom(albedo, 1.0));
    for (const Technique technique : {Technique::Deferred, Technique::PathTracer}) {
        Renderer renderer(lab.device(), scene, furnaceSettings(technique), lab.pipelines());
        const uint32_t frames = technique == Technique::PathTracer ? 4 : 1;
        const int bounces = renderer.settings().bounceCount.value_or(0);
        // The depth limit is part of what is expected: what it cuts off is known.
        const std::string what = fmt::format("a = {}, {}, {} bounces, cut off {:.1e}", albedo, name(technique), bounces,
                                             std::pow(albedo, bounces + 2));
        findings.push_back(meanIs(what, lab.means(renderer, renderer.settings(), 16, frames),
                                  truncatedFurnace(albedo, bounces),
                                  0.03));  // 3 %: an error of one bounce in a hundred would show at 5 of them
    }
}

}  // namespace

Findings furnace(StabilityLab& lab) {
    Findings findings;
    for (const double albedo : {0.5, 0.8, 0.9}) addFurnace(lab, findings, albedo);
    return findings;
}

Findings furnaceStiff(StabilityLab& lab) {
    Findings findings;
    for (const double albedo : {0.99, 0.999}) addFurnace(lab, findings, albedo);
    return findings;
}

}  // namespace manylight::stability
