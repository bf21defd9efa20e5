// Where little light, or light from very near, decides about the picture.
#include "apps/bench/stability/families.h"
#include "apps/bench/stability/lab.h"
#include "apps/bench/stability/scenes.h"

#include <fmt/format.h>
#include "engine/core/statistics.h"

#include <cmath>
#include <numeric>

namespace manylight::stability {
namespace {

/// Deferred shading, unclamped and compensated, against the path tracer: none shares its estimators. `frames` of each.
Findings agreement(StabilityLab& lab, const Scene& scene, RenderSettings settings, uint32_t frames,
                   uint32_t framesOfPathTracer, double largestError) {
    Renderer renderer(lab.device(), scene, settings, lab.pipelines());
    const std::vector<double> reference =
        lab.means(renderer, withTechnique(settings, Technique::PathTracer), 16, framesOfPathTracer);
    Findings findings;
    for (const ClampMode clamp : {ClampMode::Off, ClampMode::Compensate})
        findings.push_back(meansAgree(fmt::format("clamp {}, path tracer", name(clamp)),
                                      lab.means(renderer, withClamp(settings, clamp), 16, frames), reference,
                                      largestError));
    return findings;
}

/// Two rooms side by side, open to each other through a slit of the given size in the wall x = 0; the lamp is in the
/// left one and the camera in the right one.
Scene roomsWithSlit(double height, double depth, double lampX) {
    RawScene raw = emptyScene();
    const uint32_t white = addMaterial(raw, glm::dvec3(0.8));
    addRoom(raw, {-0.5, -0.25, -0.25}, {0.5, 0.25, 0.25}, white);
    const double h = height / 2.0;
    const double d = depth / 2.0;
    addQuad(raw, {0, -0.25, -0.25}, {0, 0.25 - h, 0}, {0, 0, 0.5}, white);
    addQuad(raw, {0, h, -0.25}, {0, 0.25 - h, 0}, {0, 0, 0.5}, white);
    if (d < 0.25) {
        addQuad(raw, {0, -h, -0.25}, {0, 2 * h, 0}, {0, 0, 0.25 - d}, white);
        addQuad(raw, {0, -h, d}, {0, 2 * h, 0}, {0, 0, 0.25 - d}, white);
    }
    addPointLight(raw, {lampX, 0.03, 0.02}, glm::dvec3(1.0));
    addCamera(raw, {0.05, 0.2, 0.2}, {0.5, -0.1, -0.05}, 1.4);
    return normalise(std::move(raw));
}

/// A room with one camera per distance: each looks at a point of the floor so far from the edge with a wall.
Scene cornerRoom(const std::vector<double>& distances) {
    RawScene raw = closedRoom(0.7);
    addPointLight(raw, {0.1, 0.2, 0.1}, glm::dvec3(1.0));
    raw.cameras.clear();
    for (const double distance : distances) addCamera(raw, {-0.1, 0.1, 0.07}, {-0.5 + distance, -0.5, 0.03}, 1e-3);
    return normalise(std::move(raw));
}

/// The same where the walls themselves shine: direct light is a sample of their area, and nothing bounds that.
void addShiningCorner(StabilityLab& lab, Findings& findings, const std::vector<double>& distances) {
    RawScene raw = closedRoom(0.5, 1.0);
    raw.cameras.clear();
    for (const double distance : distances) addCamera(raw, {-0.1, 0.1, 0.07}, {-0.5 + distance, -0.5, 0.03}, 1e-3);
    const Scene scene = normalise(std::move(raw));
    RenderSettings settings = withClamp(stabilitySettings(1, 1), ClampMode::Compensate);
    settings.lightSampleCount = 256;
    Renderer renderer(lab.device(), scene, settings, lab.pipelines());
    for (uint32_t i = 0; i < distances.size(); ++i) {
        settings.camera = i;
        findings.push_back(meanIs(fmt::format("shining walls at {:.0e}, path tracer", distances[i]),
                                  lab.means(renderer, withTechnique(settings, Technique::PathTracer), 16, 64), 2.0,
                                  0.02));
        const Estimate mean = estimate(lab.means(renderer, settings, 16, 2));
        findings.push_back(shown(fmt::format("shining walls at {:.0e}, deferred", distances[i]), "2",
                                 fmt::format("{:.4f} +- {:.1e}", mean.mean, mean.error)));
    }
}

/// `frames` of the compensated picture, four times as many of the path tracer's.
Findings cornersAt(StabilityLab& lab, const std::vector<double>& distances, uint32_t frames) {
    const Scene scene = cornerRoom(distances);
    RenderSettings settings = stabilitySettings(1, 1);
    settings.lighting = Lighting::Global;
    Renderer renderer(lab.device(), scene, settings, lab.pipelines());
    Findings findings;
    for (uint32_t i = 0; i < distances.size(); ++i) {
        settings.camera = i;
        const std::vector<double> reference =
            lab.means(renderer, withTechnique(settings, Technique::PathTracer), 16, 4 * frames);
        findings.push_back(meansAgree(fmt::format("compensated at {:.0e}, path tracer", distances[i]),
                                      lab.means(renderer, withClamp(settings, ClampMode::Compensate), 16, frames),
                                      reference, 0.05));  // unbounded, a quarter and more is missing at 1e-3
        for (const ClampMode clamp : {ClampMode::Off, ClampMode::Bound}) {
            const Estimate mean = estimate(lab.means(renderer, withClamp(settings, clamp), 16, 4));
            // Without a bound rare samples carry the light; the bound leaves it out: neither can be held to the value.
            findings.push_back(shown(fmt::format("clamp {} at {:.0e}", name(clamp), distances[i]),
                                     fmt::format("{:.4g}", estimate(reference).mean),
                                     fmt::format("{:.4g} +- {:.1e}", mean.mean, mean.error)));
        }
    }
    return findings;
}

}  // namespace

Findings concaveCornerQuick(StabilityLab& lab) { return cornersAt(lab, {1e-2, 1e-4, 1e-6}, 12); }

Findings concaveCorner(StabilityLab& lab) {
    Findings findings = cornersAt(lab, {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}, 32);
    addShiningCorner(lab, findings, {1e-2, 1e-4, 1e-6});
    return findings;
}

Findings glancing(StabilityLab& lab) {
    // Two plates, a fiftieth of their length apart, lit from one end: light arrives at less than two degrees.
    RawScene raw = emptyScene();
    const uint32_t white = addMaterial(raw, glm::dvec3(0.9));
    addRoom(raw, {-0.5, -0.01, -0.3}, {0.5, 0.01, 0.3}, white);
    addQuad(raw, {-0.49, -0.01, -0.3}, {0, 0.02, 0}, {0, 0, 0.6}, addMaterial(raw, glm::dvec3(0.0), glm::dvec3(10.0)));
    addCamera(raw, {-0.2, 0.008, 0.1}, {0.0, 0.0, 0.0}, 0.6);
    return agreement(lab, normalise(std::move(raw)), stabilitySettings(8, 8), 24, 96, 0.1);
}

Findings keyhole(StabilityLab& lab) {
    return agreement(lab, roomsWithSlit(0.02, 0.02, -0.1), stabilitySettings(8, 8), 32, 128, 0.1);
}

Findings crackBetweenRooms(StabilityLab& lab) {
    return agreement(lab, roomsWithSlit(1e-3, 0.5, -0.02), stabilitySettings(8, 8), 32, 128, 0.1);
}

Findings unequalLights(StabilityLab& lab) {
    // A furnace without an exit beside one 1e10 times as bright: its radiance is known, and only its own light can
    // show it.
    RawScene raw = emptyScene();
    addRoom(raw, {-0.5, -0.25, -0.25}, {-0.01, 0.25, 0.25}, addMaterial(raw, glm::dvec3(0.5), glm::dvec3(1e10)));
    addRoom(raw, {0.01, -0.25, -0.25}, {0.5, 0.25, 0.25}, addMaterial(raw, glm::dvec3(0.5), glm::dvec3(1.0)));
    addCamera(raw, {0.4, 0.1, 0.1}, {0.1, -0.1, -0.1}, 1.2);
    const Scene scene = normalise(std::move(raw));
    RenderSettings settings = withClamp(stabilitySettings(), ClampMode::Compensate);
    settings.vplCount = 2048;
    Findings findings;
    // One path in twenty starts in the weak room; an alias table does not stratify how many. So many seeds, as rays
    // that all went to the strong room's lights would cost as little as 2 % here.
    findings.push_back(meanIs("deferred, weak room", lab.means(scene, settings, 64, 6), 2.0, 0.02));
    RenderSettings filtered = settings;
    filtered.lighting = Lighting::Local;
    filtered.filter = Filter::Atrous;
    filtered.interleave = 2;
    const std::vector<double> means = lab.means(scene, filtered, 64, 6);
    const double mean = std::accumulate(means.begin(), means.end(), 0.0) / static_cast<double>(means.size());
    // A filter is biased: what rare samples bring stays where it is. Where none goes to the weak room, 1.29 is left.
    findings.push_back(holds("filtered direct light, weak room", "1.5 within 5 %", fmt::format("{:.4g}", mean),
                             std::abs(mean - 1.5) < 0.05 * 1.5));
    findings.push_back(meanIs("path tracer, weak room",
                              lab.means(scene, withTechnique(settings, Technique::PathTracer), 16, 16), 2.0, 0.02));
    return findings;
}

Findings extremeBounds(StabilityLab& lab) {
    const Scene scene = normalise(furnishedRoom());
    RenderSettings settings = stabilitySettings(12, 12);
    Renderer renderer(lab.device(), scene, settings, lab.pipelines());
    const Image unclamped = lab.render(renderer, settings);
    Findings findings;
    RenderSettings bounded = withClamp(settings, ClampMode::Bound);
    bounded.clampBound = 1e30f;
    findings.push_back(sameBytes("bound of 1e30, no bound", lab.render(renderer, bounded), unclamped));
    const std::vector<double> reference = lab.means(renderer, withTechnique(settings, Technique::PathTracer), 16, 16);
    for (const float c : {1e-6f, 1.0f, 1e6f}) {
        RenderSettings compensated = withClamp(settings, ClampMode::Compensate);
        compensated.clampBound = c;
        // 3 %: with 1e-6 all of the indirect light, a third of this picture, is left to the compensation.
        findings.push_back(meansAgree(fmt::format("compensate, c = {:.0e}, path tracer", c),
                                      lab.means(renderer, compensated, 16, 8), reference, 0.03));
    }
    for (const char* value : {"-1", "nan", "inf"})
        findings.push_back(isRefused(fmt::format("--clamp-bound {}", value), "clamp-bound",
                                     [&] { applySetting(bounded, "clamp-bound", value); }));
    return findings;
}

}  // namespace manylight::stability
