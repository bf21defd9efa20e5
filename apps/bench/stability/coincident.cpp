// Things in the same place.
#include "apps/bench/stability/families.h"
#include "apps/bench/stability/lab.h"
#include "apps/bench/stability/scenes.h"

#include <cmath>

namespace manylight::stability {
namespace {

/// A lamp at the camera that lights the one point which the single pixel shows: VPLs on the receiver itself.
RawScene lampAtCamera(glm::dvec3 origin, glm::dvec3 target) {
    RawScene raw = closedRoom(0.5);
    addSphere(raw, {0.2, -0.2, -0.2}, 0.2, 4, false, true, 0);
    addQuad(raw, {-0.45, -0.45, -0.45}, {0.31, 0.07, 0.05}, {0.03, 0.29, -0.11}, 0);
    raw.cameras.clear();
    addCamera(raw, origin, target, 1e-3);
    addSpotLight(raw, origin, target - origin, glm::dvec3(1.0), 1e-3);
    return raw;
}

RawScene withTwins(RawScene raw) {
    const std::vector<RawTriangle> triangles = raw.triangles;
    raw.triangles.insert(raw.triangles.end(), triangles.begin(), triangles.end());
    return raw;
}

}  // namespace

Findings vplOnReceiver(StabilityLab& lab) {
    // VPL and receiver lie on one plane, or on one convex side: G is 0 between them, and the path tracer knows no
    // light from there either. Rounding must not make a light of it.
    Findings findings;
    struct Place {
        const char* what;
        glm::dvec3 target;
    };
    for (const Place place : {Place{"floor", {-0.05, -0.5, 0.31}}, Place{"tilted card", {-0.28, -0.27, -0.475}},
                              Place{"smooth sphere", {0.12, -0.1, -0.06}}}) {
        const Scene scene = normalise(lampAtCamera({0.0, 0.3, 0.4}, place.target));
        RenderSettings settings = stabilitySettings(1, 1);
        settings.bounceCount = 1;
        Renderer renderer(lab.device(), scene, settings, lab.pipelines());
        settings.lighting = Lighting::Local;
        const double local = meanOf(lab.render(renderer, settings));
        settings.lighting = Lighting::Both;
        for (const ClampMode clamp : {ClampMode::Off, ClampMode::Compensate}) {
            const double both = meanOf(lab.render(renderer, withClamp(settings, clamp), 4));
            // All VPLs are within 1e-3 of the pixel.
            findings.push_back(
                closeTo(fmt::format("{}, clamp {}: nothing added", place.what, name(clamp)), both, local, 1e-4));
        }
    }
    return findings;
}

Findings coincidentVpls(StabilityLab& lab) {
    // A beam so narrow that all paths end in one point: a hundred thousand VPLs there are as one of all their light.
    RawScene raw = closedRoom(0.5);
    addSpotLight(raw, {0.1, 0.2, 0.1}, {0.3, -1.0, 0.2}, glm::dvec3(1e6), 1e-3);
    const Scene scene = normalise(std::move(raw));
    RenderSettings settings = stabilitySettings(8, 8);
    settings.lighting = Lighting::Global;
    settings.bounceCount = 1;
    settings.castShadows = false;  // a convex room has none
    Renderer renderer(lab.device(), scene, settings, lab.pipelines());
    settings.vplCount = 1;
    const Image one = lab.render(renderer, settings);
    settings.vplCount = 1000;
    const Image thousand = lab.render(renderer, settings);
    settings.vplCount = 100000;
    const Image many = lab.render(renderer, settings);
    Findings findings;
    // Within 1e-3 rad of one another, 0.7e-3 apart, seen from 0.2 at least: G differs by 2 * 0.7e-3 / 0.2.
    findings.push_back(closePictures("1000 VPLs, one", thousand, one, 7e-3));
    // The spots of both fill the beam; what is left is rounding of the sum and a thousandth of the above.
    findings.push_back(closePictures("100000 VPLs, 1000", many, thousand, 1e-4));
    return findings;
}

Findings coplanar(StabilityLab& lab) {
    Findings findings;
    // A lamp in the plane of the ceiling: neither may shadow the other.
    const auto room = [](bool ceiling) {
        RawScene raw = emptyScene();
        const uint32_t white = addMaterial(raw, glm::dvec3(0.5));
        addQuad(raw, {-0.5, -0.5, -0.5}, {0, 0, 1}, {1, 0, 0}, white);
        addQuad(raw, {-0.1, 0.5, -0.1}, {0.2, 0, 0}, {0, 0, 0.2}, addMaterial(raw, glm::dvec3(0.0), glm::dvec3(10.0)));
        const double reach = ceiling ? 1.0 : 1e-3;  // the frame stays the same: a scrap in each corner keeps the bounds
        for (const glm::dvec3 corner : {glm::dvec3(-0.5, 0.5, -0.5), glm::dvec3(0.5 - reach, 0.5, 0.5 - reach)})
            addQuad(raw, corner, {reach, 0, 0}, {0, 0, reach}, white);
        addCamera(raw, {0.3, -0.1, 0.4}, {0, -0.5, 0}, 0.8);
        return normalise(std::move(raw));
    };
    for (const Technique technique : {Technique::Deferred, Technique::Forward}) {
        RenderSettings settings = withTechnique(stabilitySettings(24, 18), technique);
        settings.lighting = Lighting::Local;
        findings.push_back(closePictures(fmt::format("lamp in a ceiling, {}", name(technique)),
                                         lab.render(room(true), settings), lab.render(room(false), settings), 1e-6));
    }
    // Overlapping floors of two colours: which is seen must not depend on who looks.
    RawScene raw = emptyScene();
    addQuad(raw, {-0.5, 0, -0.5}, {0, 0, 1}, {1, 0, 0}, addMaterial(raw, glm::dvec3(0.8, 0.1, 0.1)));
    addQuad(raw, {-0.3, 0, -0.4}, {0, 0, 0.8}, {0.7, 0, 0}, addMaterial(raw, glm::dvec3(0.1, 0.8, 0.1)));
    addPointLight(raw, {0.1, 0.5, 0.1}, glm::dvec3(1.0));
    addCamera(raw, {0.1, 0.7, 0.3}, {0, 0, 0}, 0.8);
    const Scene floors = normalise(std::move(raw));
    const RenderSettings settings = stabilitySettings(24, 18);
    const Image deferred = lab.render(floors, settings);
    findings.push_back(sameBytes("overlapping floors, again", lab.render(floors, settings), deferred));
    for (const Technique technique : {Technique::Forward, Technique::ForwardPrepass})
        findings.push_back(closePictures(fmt::format("overlapping floors, {}, deferred", name(technique)),
                                         lab.render(floors, withTechnique(settings, technique)), deferred, 1e-5));
    return findings;
}

Findings duplicates(StabilityLab& lab) {
    RawScene raw = furnishedRoom();
    for (RawMaterial& material : raw.materials) material.emittedRadiance = glm::dvec3(0.0);  // twins would shine twice
    Findings findings;
    for (const Technique technique : {Technique::Deferred, Technique::PathTracer}) {
        const RenderSettings settings = withTechnique(stabilitySettings(24, 18), technique);
        findings.push_back(sameBytes(fmt::format("every triangle twice, {}", name(technique)),
                                     lab.render(normalise(withTwins(raw)), settings),
                                     lab.render(normalise(RawScene(raw)), settings)));
    }
    RenderSettings byRays = stabilitySettings(24, 18);
    byRays.gbuffer = GBufferBy::Rays;
    findings.push_back(sameBytes("every triangle twice, deferred by rays",
                                 lab.render(normalise(withTwins(raw)), byRays),
                                 lab.render(normalise(RawScene(raw)), byRays)));
    return findings;
}

}  // namespace manylight::stability
