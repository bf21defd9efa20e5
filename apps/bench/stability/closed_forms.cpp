// Scenes whose light is known on paper.
#include "apps/bench/stability/families.h"
#include "apps/bench/stability/lab.h"
#include "apps/bench/stability/scenes.h"
#include "shaders/shared/constants.h"

#include "engine/core/statistics.h"
#include <fmt/format.h>

#include <cmath>

namespace manylight::stability {
namespace {

constexpr double kPi = shared::kPi;
constexpr double kRadius = 0.5;

/// Albedo 1/2 and a light pi R^2 at the centre: radiance 1/2 directly, 1/2^(k+1) after k bounces.
RawScene sphere(int levels) {
    RawScene raw = emptyScene();
    addSphere(raw, glm::dvec3(0.0), kRadius, levels, true, false, addMaterial(raw, glm::dvec3(0.5)));
    addCamera(raw, {0.1, 0.05, 0.2}, {-0.2, -0.1, -1.0}, 1.4);
    return raw;
}

/// The largest angle between a facet's normal and the direction of its corners. Errors of a tessellation are of the
/// order of its square: by it a facet is nearer to the centre, and the cosines at both ends of a ray are off.
double tiltOf(const Scene& scene) {
    double largest = 0.0;
    for (const Triangle& triangle : scene.triangles) {
        const glm::dvec3 a = scene.vertices[triangle.vertex[0]].position;
        const glm::dvec3 b = scene.vertices[triangle.vertex[1]].position;
        const glm::dvec3 c = scene.vertices[triangle.vertex[2]].position;
        const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
        largest = std::max(largest, std::acos(-glm::dot(normal, glm::normalize(a))));
    }
    return largest;
}

/// Flux of the VPLs of depth `depth`, of all or of those that `isCounted` takes. A VPL's intensity is flux * albedo /
/// pi.
template <typename IsCounted>
double fluxOf(const std::vector<shared::LightData>& vpls, uint32_t depth, double albedo, IsCounted isCounted) {
    double flux = 0.0;
    for (const shared::LightData& vpl : vpls)
        if (vpl.intensity > 0.0f && vpl.depth == depth && isCounted(vpl))
            flux += double{vpl.intensity} * double{vpl.colour.x} * kPi / albedo;
    return flux;
}

/// Power of light paths that an emitting patch sends to another, over all it sends: the form factor, of 16 seeds. `raw`
/// has the emitter (radiance 1/pi: its power is its area) and the receiver of albedo 1/2, where z < `below`.
std::vector<double> formFactor(StabilityLab& lab, RawScene raw, double emitterArea, float below) {
    addCamera(raw, {3, 3, 3}, {0, 0, 0}, 0.5);
    const Scene scene = normalise(std::move(raw));
    RenderSettings settings = stabilitySettings(1, 1);
    settings.vplCount = settings.pathCount = 1u << 14;
    settings.bounceCount = 1;
    settings.castShadows = false;
    Renderer renderer(lab.device(), scene, settings, lab.pipelines());
    renderer.keepVpls();
    const double unit = std::ldexp(1.0, scene.frame.exponent);  // areas below are in the scene's own unit
    std::vector<double> factors;
    for (settings.seed = 0; settings.seed < 16; ++settings.seed) {
        lab.render(renderer, settings);
        const double flux = fluxOf(renderer.vpls(), 1, 0.5, [&](const shared::LightData& vpl) {
            return double{vpl.position.z} * unit + scene.frame.center.z < double{below};
        });
        factors.push_back(flux * unit * unit / emitterArea);
    }
    return factors;
}

RawScene twoSquares(glm::dvec3 corner, glm::dvec3 u, glm::dvec3 v) {
    RawScene raw = emptyScene();
    const uint32_t lamp = addMaterial(raw, glm::dvec3(0.0), glm::dvec3(1.0 / kPi));
    addQuad(raw, corner, u, v, lamp);
    addQuad(raw, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, addMaterial(raw, glm::dvec3(0.5)));
    return raw;
}

void addDisk(RawScene& raw, double z, double side, uint32_t material) {
    constexpr int kCorners = 256;
    const auto corner = [&](int i) {
        const double angle = side * 2.0 * kPi * i / kCorners;
        return glm::dvec3(std::cos(angle), std::sin(angle), z);
    };
    for (int i = 0; i < kCorners; ++i) addTriangle(raw, {0, 0, z}, corner(i), corner(i + 1), material);
}

/// Irradiance from a polygon of radiance 1 at the origin with normal +y (Lambert), the polygon above the horizon.
double lambertIrradiance(const std::vector<glm::dvec3>& corners) {
    double sum = 0.0;
    for (size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = glm::normalize(corners[i]);
        const glm::dvec3 b = glm::normalize(corners[(i + 1) % corners.size()]);
        const glm::dvec3 across = glm::normalize(glm::cross(a, b));
        sum += std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)) * across.y;
    }
    return 0.5 * std::abs(sum);
}

}  // namespace

Findings integratingSphere(StabilityLab& lab) {
    RawScene raw = sphere(5);
    addPointLight(raw, glm::dvec3(0.0), glm::dvec3(kPi * kRadius * kRadius));
    const Scene scene = normalise(RawScene(raw));
    const double tilt = tiltOf(scene);
    RenderSettings settings = stabilitySettings();
    settings.lighting = Lighting::Local;
    Findings findings;
    findings.push_back(closeTo("direct light", meanOf(lab.render(scene, settings)), 0.5, tilt * tilt));
    settings.lighting = Lighting::Both;
    // One tilt^2 per meeting with the tessellation, of which the light that is seen has had two on average.
    findings.push_back(
        closeTo("all light, deferred", estimate(lab.means(scene, settings)).mean, 1.0, 4.0 * tilt * tilt));
    findings.push_back(meanIs("all light, path tracer",
                              lab.means(scene, withTechnique(settings, Technique::PathTracer), 16, 4), 1.0, 0.02));
    raw.lights.clear();
    for (int i = 0; i < 4; ++i) addPointLight(raw, glm::dvec3(0.0), glm::dvec3(kPi * kRadius * kRadius / 4.0));
    settings.lighting = Lighting::Local;
    findings.push_back(
        closeTo("four lights for one", meanOf(lab.render(normalise(std::move(raw)), settings)), 0.5, tilt * tilt));
    return findings;
}

Findings singlePath(StabilityLab& lab) {
    RawScene raw = sphere(5);
    addPointLight(raw, glm::dvec3(0.0), glm::dvec3(kPi * kRadius * kRadius));
    const Scene scene = normalise(std::move(raw));
    const double tilt = tiltOf(scene);
    Findings findings;
    for (const int bounces : {1, 2, 4, 8}) {
        RenderSettings settings = stabilitySettings();
        settings.vplCount = static_cast<uint32_t>(bounces);
        settings.pathCount = 1;
        settings.bounceCount = bounces;
        settings.russianRoulette = false;
        // A VPL's facet is tilted by up to `tilt`, which a single path does not average out: first order in the light
        // of VPLs, which is (1 - 0.5^D) / 2.
        findings.push_back(closeTo(fmt::format("one path of {} bounces", bounces), meanOf(lab.render(scene, settings)),
                                   1.0 - std::pow(0.5, bounces + 1), 0.5 * tilt));
    }
    return findings;
}

Findings formFactors(StabilityLab& lab) {
    Findings findings;
    constexpr double kLargestError = 5e-3;  // 16 x 2^14 independent paths would leave 0.4 %
    findings.push_back(meanIs("parallel unit squares",
                              formFactor(lab, twoSquares({0, 0, 1}, {0, 1, 0}, {1, 0, 0}), 1.0, 0.5f), 0.199825,
                              kLargestError));
    findings.push_back(meanIs("squares that share an edge",
                              formFactor(lab, twoSquares({0, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1.0, 1e-4f), 0.200044,
                              kLargestError));
    RawScene disks = emptyScene();
    addDisk(disks, 1.0, -1.0, addMaterial(disks, glm::dvec3(0.0), glm::dvec3(1.0 / kPi)));
    addDisk(disks, 0.0, 1.0, addMaterial(disks, glm::dvec3(0.5)));
    findings.push_back(meanIs("disks", formFactor(lab, std::move(disks), kPi, 0.5f), 0.381966, kLargestError));
    std::vector<double> there = formFactor(lab, twoSquares({0.2, 0.2, 0.5}, {0, 0.3, 0}, {0.3, 0, 0}), 0.09, 0.25f);
    for (double& factor : there) factor *= 0.09;
    RawScene swapped = emptyScene();
    const uint32_t lamp = addMaterial(swapped, glm::dvec3(0.0), glm::dvec3(1.0 / kPi));
    addQuad(swapped, {0, 0, 0.5}, {0, 1, 0}, {1, 0, 0}, lamp);
    addQuad(swapped, {0.2, 0.2, 0}, {0.3, 0, 0}, {0, 0.3, 0}, addMaterial(swapped, glm::dvec3(0.5)));
    findings.push_back(meansAgree("reciprocity: F12 A1 = F21 A2", formFactor(lab, std::move(swapped), 1.0, 0.25f),
                                  there,
                                  3.0 * kLargestError));  // an eleventh of the paths meets the small square
    return findings;
}

Findings polygonLights(StabilityLab& lab) {
    const std::vector<std::vector<glm::dvec3>> polygons = {
        {{-0.2, 0.5, -0.2}, {0.2, 0.5, -0.2}, {0.2, 0.5, 0.2}, {-0.2, 0.5, 0.2}},
        {{0.1, 0.02, 0.3}, {0.4, 0.3, 0.1}, {0.2, 0.6, -0.3}},
        {{0.3, 1e-3, -0.4}, {0.3, 1e-3, 0.4}, {0.3, 0.3, 0.4}, {0.3, 0.3, -0.4}}};
    Findings findings;
    for (const std::vector<glm::dvec3>& corners : polygons) {
        RawScene raw = emptyScene();
        const uint32_t lamp = addMaterial(raw, glm::dvec3(0.0), glm::dvec3(1.0));
        for (size_t i = 1; i + 1 < corners.size(); ++i) {
            const bool isFront =
                glm::dot(glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]), corners[0]) < 0.0;
            addTriangle(raw, corners[0], corners[isFront ? i : i + 1], corners[isFront ? i + 1 : i], lamp);
        }
        addQuad(raw, {-0.5, 0, -0.5}, {0, 0, 1}, {1, 0, 0}, addMaterial(raw, glm::dvec3(1.0)));
        addCamera(raw, {-0.3, 0.2, 0.1}, {0, 0, 0}, 1e-3);
        const Scene scene = normalise(std::move(raw));
        RenderSettings settings = stabilitySettings(1, 1);
        settings.vplCount = 0;
        settings.bounceCount = 0;
        settings.lightSampleCount = 1024;
        const double radiance = lambertIrradiance(corners) / kPi;
        const std::string what = fmt::format("{} corners, ", corners.size());
        findings.push_back(meanIs(what + "deferred", lab.means(scene, settings), radiance, 0.02));
        findings.push_back(meanIs(what + "path tracer",
                                  lab.means(scene, withTechnique(settings, Technique::PathTracer), 16, 64), radiance,
                                  0.05));
    }
    return findings;
}

Findings energyBalance(StabilityLab& lab) {
    constexpr double kAlbedo = 0.5;
    RawScene raw = closedRoom(kAlbedo);
    addPointLight(raw, {0.1, 0.2, 0.1}, glm::dvec3(1.0 / (4.0 * kPi)));  // 1 W
    const Scene scene = normalise(std::move(raw));
    RenderSettings settings = stabilitySettings(1, 1);
    settings.pathCount = 256;
    settings.vplCount = 2048;
    Renderer renderer(lab.device(), scene, settings, lab.pipelines());
    renderer.keepVpls();
    constexpr uint32_t kDepths = 5;
    std::vector<std::vector<double>> flux(kDepths + 1);
    for (settings.seed = 0; settings.seed < 16; ++settings.seed) {
        lab.render(renderer, settings);
        for (uint32_t depth = 1; depth <= kDepths; ++depth)
            flux[depth].push_back(fluxOf(renderer.vpls(), depth, kAlbedo, [](const auto&) { return true; }));
    }
    Findings findings;
    for (uint32_t depth = 1; depth <= kDepths; ++depth)
        findings.push_back(meanIs(fmt::format("flux of bounce {}", depth), flux[depth], std::pow(kAlbedo, depth - 1.0),
                                  0.1));  // 16 x 16 paths are left at the fifth bounce: 1 / sqrt(256)
    return findings;
}

}  // namespace manylight::stability
