// Lengths and light in units far from one.
#include "apps/bench/stability/families.h"
#include "apps/bench/stability/lab.h"
#include "apps/bench/stability/scenes.h"

#include <fmt/format.h>

#include <cmath>

namespace manylight::stability {
namespace {

constexpr Technique kTechniques[] = {Technique::Deferred, Technique::PathTracer};

RenderSettings pictureSettings(Technique technique) {
    RenderSettings settings = withTechnique(stabilitySettings(24, 18), technique);
    if (technique == Technique::Deferred) settings.clamp = ClampMode::Compensate;
    return settings;
}

}  // namespace

Findings powerOfTwoUnits(StabilityLab& lab) {
    Findings findings;
    for (const Technique technique : kTechniques) {
        const RenderSettings settings = pictureSettings(technique);
        const Image reference = lab.render(normalise(furnishedRoom()), settings);
        for (const int k : {-60, -1, 31, 60})
            findings.push_back(sameBytes(fmt::format("{}, lengths x 2^{}", name(technique), k),
                                         lab.render(normalise(inUnit(furnishedRoom(), std::ldexp(1.0, k))), settings),
                                         reference));
    }
    return findings;
}

Findings powerOfTenUnits(StabilityLab& lab) {
    Findings findings;
    RenderSettings settings = pictureSettings(Technique::Deferred);
    // The list takes all vertices: of a sample, one vertex more or less would exchange all the others.
    settings.pathCount = 128;
    settings.vplCount = 1024;
    const auto emptyRoom = [] {
        RawScene raw = closedRoom(0.6);
        addPointLight(raw, {-0.3, 0.2, 0.3}, {0.2, 0.15, 0.1});
        return raw;
    };
    // A ray that rounding turns past an edge exchanges the rest of its path, a picture's light by 1e-4: rare, and to
    // either side, so that of many frames less is left.
    constexpr uint32_t kFrames = 64;
    const Image empty = lab.render(normalise(emptyRoom()), settings, kFrames);
    const Image furnished = lab.render(normalise(furnishedRoom()), settings, kFrames);
    for (const int k : {-9, -6, -3, -1, 1, 3, 6, 9, 12}) {
        const double unit = std::pow(10.0, k);
        findings.push_back(closePictures(fmt::format("lengths x 1e{}, empty room", k),
                                         lab.render(normalise(inUnit(emptyRoom(), unit)), settings, kFrames), empty,
                                         1e-5));
        findings.push_back(closePictures(fmt::format("lengths x 1e{}, furnished room", k),
                                         lab.render(normalise(inUnit(furnishedRoom(), unit)), settings, kFrames),
                                         furnished, 1e-5));
    }
    return findings;
}

Findings farFromOrigin(StabilityLab& lab) {
    Findings findings;
    const RenderSettings settings = pictureSettings(Technique::Deferred);
    const Image reference = lab.render(normalise(furnishedRoom()), settings);
    for (const double offset : {1e3, 1e4, 1e5, 1e6, 1e7, 1e8})
        // In double precision 1e8 sizes away, a coordinate keeps 1.5e-8: less than half a step of single precision
        // here.
        findings.push_back(
            closePictures(fmt::format("{:.0e} sizes from the origin", offset),
                          lab.render(normalise(movedBy(furnishedRoom(), {offset, -offset, 0.7 * offset})), settings),
                          reference, 1e-5));
    return findings;
}

Findings farApart(StabilityLab& lab) {
    // Two lit rooms of size 1, `distance` apart, the camera in one. Beyond 1e3 the steps of single precision, and the
    // distance by which rays leave surfaces, are no longer small beside a room: a documented limit.
    Findings findings;
    const RenderSettings settings = pictureSettings(Technique::Deferred);
    const std::vector<double> alone = lab.means(normalise(furnishedRoom()), settings, 16, 4);
    for (const double distance : {1e1, 1e2, 1e3, 1e4, 1e5, 1e7}) {
        RawScene raw = furnishedRoom();
        const RawScene other = movedBy(furnishedRoom(), {distance, 0, 0});
        const auto first = static_cast<uint32_t>(raw.vertices.size());
        raw.vertices.insert(raw.vertices.end(), other.vertices.begin(), other.vertices.end());
        for (RawTriangle triangle : other.triangles) {
            for (uint32_t& vertex : triangle.vertex) vertex += first;
            raw.triangles.push_back(triangle);
        }
        raw.lights.insert(raw.lights.end(), other.lights.begin(), other.lights.end());
        // Half of the paths are spent on the other room: the pictures agree in their means, not in their samples.
        Finding finding = meansAgree(fmt::format("{:.0e} sizes apart, alone", distance),
                                     lab.means(normalise(std::move(raw)), settings, 16, 4), alone, 0.02);
        if (distance > 1e3) finding.verdict = Verdict::Shown;
        findings.push_back(std::move(finding));
    }
    return findings;
}

Findings brightAndDim(StabilityLab& lab) {
    Findings findings;
    for (const Technique technique : kTechniques) {
        const RenderSettings settings = pictureSettings(technique);
        const Image reference = lab.render(normalise(furnishedRoom()), settings);
        for (const int k : {-100, -50, -1, 1, 50, 100})
            findings.push_back(exactlyScaled(fmt::format("{}, light x 2^{}", name(technique), k),
                                             lab.render(normalise(withLight(furnishedRoom(), k)), settings), reference,
                                             k));
    }
    return findings;
}

Findings rangeOfFloat(StabilityLab& lab) {
    Findings findings;
    RenderSettings settings = pictureSettings(Technique::Deferred);
    Image reference = lab.render(normalise(furnishedRoom()), settings);
    findings.push_back(exactlyScaled("light x 2^120", lab.render(normalise(withLight(furnishedRoom(), 120)), settings),
                                     reference, 120));
    for (float& value : reference.texels) value = std::ldexp(value, -120);
    // Dark pixels of a picture of 2e-37 are denormal: they lose digits, or become 0 where a device flushes them.
    findings.push_back(closePictures(
        "light x 2^-120", lab.render(normalise(withLight(furnishedRoom(), -120)), settings), reference, 0.02));
    settings.checkFinite = true;
    // What exceeds the range must be said, not shown.
    findings.push_back(isRefused("light x 2^127, --check-finite", "not finite",
                                 [&] { lab.render(normalise(withLight(furnishedRoom(), 127)), settings); }));
    findings.push_back(countIs("emission beyond it, repaired",
                               normalise(withLight(furnishedRoom(), 127))
                                   .warnings.count("emission channels set to zero: negative, not finite or too large"),
                               1));
    return findings;
}

}  // namespace manylight::stability
