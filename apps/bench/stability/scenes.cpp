#include "apps/bench/stability/scenes.h"

#include <cmath>

namespace manylight::stability {
namespace {

struct Sphere {
    glm::dvec3 center;
    double radius;
    bool inwards;
    bool smooth;
    uint32_t material;
};

uint32_t addVertex(RawScene& raw, glm::dvec3 position) {
    raw.vertices.push_back({.position = position});
    return static_cast<uint32_t>(raw.vertices.size() - 1);
}

/// `a`, `b`, `c` are unit directions, counter-clockwise seen from outside.
void addSpherePatch(RawScene& raw, const Sphere& sphere, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, int levels) {
    if (levels > 0) {
        const glm::dvec3 ab = glm::normalize(a + b);
        const glm::dvec3 bc = glm::normalize(b + c);
        const glm::dvec3 ca = glm::normalize(c + a);
        addSpherePatch(raw, sphere, a, ab, ca, levels - 1);
        addSpherePatch(raw, sphere, ab, b, bc, levels - 1);
        addSpherePatch(raw, sphere, ca, bc, c, levels - 1);
        addSpherePatch(raw, sphere, ab, bc, ca, levels - 1);
        return;
    }
    const auto corner = [&](glm::dvec3 direction) {
        raw.vertices.push_back({.position = sphere.center + sphere.radius * direction,
                                .normal = sphere.inwards ? -direction : direction,
                                .hasNormal = sphere.smooth});
        return static_cast<uint32_t>(raw.vertices.size() - 1);
    };
    const uint32_t first = corner(a);
    const uint32_t second = corner(sphere.inwards ? c : b);
    const uint32_t third = corner(sphere.inwards ? b : c);
    raw.triangles.push_back({{first, second, third}, sphere.material, 0});
}

}  // namespace

uint32_t addMaterial(RawScene& raw, glm::dvec3 albedo, glm::dvec3 emittedRadiance) {
    raw.materials.push_back({.name = "material", .albedo = albedo, .emittedRadiance = emittedRadiance});
    return static_cast<uint32_t>(raw.materials.size() - 1);
}

void addTriangle(RawScene& raw, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, uint32_t material) {
    const uint32_t first = addVertex(raw, a);
    addVertex(raw, b);
    addVertex(raw, c);
    raw.triangles.push_back({{first, first + 1, first + 2}, material, static_cast<uint32_t>(raw.triangles.size())});
}

void addQuad(RawScene& raw, glm::dvec3 corner, glm::dvec3 u, glm::dvec3 v, uint32_t material, uint32_t cells) {
    const auto first = static_cast<uint32_t>(raw.vertices.size());
    for (uint32_t j = 0; j <= cells; ++j)
        for (uint32_t i = 0; i <= cells; ++i)
            addVertex(raw, corner + u * (static_cast<double>(i) / cells) + v * (static_cast<double>(j) / cells));
    for (uint32_t j = 0; j < cells; ++j)
        for (uint32_t i = 0; i < cells; ++i) {
            const uint32_t a = first + j * (cells + 1) + i;
            const uint32_t d = a + cells + 1;
            raw.triangles.push_back({{a, a + 1, d + 1}, material, 0});
            raw.triangles.push_back({{a, d + 1, d}, material, 0});
        }
}

void addRoom(RawScene& raw, glm::dvec3 low, glm::dvec3 high, uint32_t material, uint32_t cells) {
    const glm::dvec3 x(high.x - low.x, 0, 0);
    const glm::dvec3 y(0, high.y - low.y, 0);
    const glm::dvec3 z(0, 0, high.z - low.z);
    addQuad(raw, low, y, z, material, cells);
    addQuad(raw, low + x, z, y, material, cells);
    addQuad(raw, low, z, x, material, cells);
    addQuad(raw, low + y, x, z, material, cells);
    addQuad(raw, low, x, y, material, cells);
    addQuad(raw, low + z, y, x, material, cells);
}

void addSphere(RawScene& raw, glm::dvec3 center, double radius, int levels, bool inwards, bool smooth,
               uint32_t material) {
    const Sphere sphere{center, radius, inwards, smooth, material};
    for (const double sx : {-1.0, 1.0})
        for (const double sy : {-1.0, 1.0})
            for (const double sz : {-1.0, 1.0}) {
                const glm::dvec3 x(sx, 0, 0);
                const glm::dvec3 y(0, sy, 0);
                const glm::dvec3 z(0, 0, sz);
                if (sx * sy * sz > 0.0)
                    addSpherePatch(raw, sphere, x, y, z, levels);
                else
                    addSpherePatch(raw, sphere, x, z, y, levels);
            }
}

void addCamera(RawScene& raw, glm::dvec3 origin, glm::dvec3 target, double verticalFov) {
    const glm::dvec3 forward = glm::normalize(target - origin);
    const glm::dvec3 up = std::abs(forward.y) > 0.9 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    RawCamera camera;
    camera.origin = origin;
    camera.forward = forward;
    camera.up = up;
    camera.verticalFov = verticalFov;
    raw.cameras.push_back(camera);
}

void addPointLight(RawScene& raw, glm::dvec3 position, glm::dvec3 intensity) {
    raw.lights.push_back({.type = LightType::Point, .name = "lamp", .position = position, .emission = intensity});
}

void addSpotLight(RawScene& raw, glm::dvec3 position, glm::dvec3 direction, glm::dvec3 intensity, double cutoff) {
    raw.lights.push_back({.type = LightType::Spot,
                          .name = "spot",
                          .position = position,
                          .direction = direction,
                          .emission = intensity,
                          .cosCutoff = std::cos(cutoff),
                          .cosBeam = std::cos(cutoff)});
}

RawScene emptyScene() {
    RawScene raw;
    raw.name = "generated";
    raw.path = "generated";
    raw.lightsAreFinal = true;
    return raw;
}

RawScene closedRoom(double albedo, double emittedRadiance) {
    RawScene raw = emptyScene();
    addRoom(raw, glm::dvec3(-0.5), glm::dvec3(0.5), addMaterial(raw, glm::dvec3(albedo), glm::dvec3(emittedRadiance)));
    addCamera(raw, {0.05, 0.1, 0.35}, {0.0, -0.1, -0.5}, 1.2);
    return raw;
}

RawScene furnishedRoom() {
    RawScene raw = emptyScene();
    const uint32_t grey = addMaterial(raw, glm::dvec3(0.6));
    const uint32_t red = addMaterial(raw, {0.7, 0.1, 0.1});
    const uint32_t green = addMaterial(raw, {0.1, 0.6, 0.2});
    addRoom(raw, glm::dvec3(-0.5), glm::dvec3(0.5), grey);
    addQuad(raw, {-0.4, -0.45, -0.4}, {0.3, 0.05, 0.1}, {0.02, 0.4, -0.05}, red);
    addSphere(raw, {0.2, -0.3, -0.1}, 0.15, 3, false, true, green);
    addQuad(raw, {-0.2, 0.49, -0.2}, {0.3, 0, 0}, {0, 0, 0.2}, addMaterial(raw, glm::dvec3(0.0), {4, 3, 2}));
    addPointLight(raw, {-0.3, 0.2, 0.3}, {0.2, 0.15, 0.1});
    addCamera(raw, {0.3, 0.25, 0.45}, {-0.05, -0.15, -0.2}, 1.2);
    return raw;
}

RawScene inUnit(RawScene raw, double factor) {
    for (RawVertex& vertex : raw.vertices) vertex.position *= factor;
    for (RawCamera& camera : raw.cameras) camera.origin *= factor;
    for (RawLight& light : raw.lights) {
        light.position *= factor;
        if (light.type == LightType::Point || light.type == LightType::Spot) light.emission *= factor * factor;
    }
    return raw;
}

RawScene movedBy(RawScene raw, glm::dvec3 offset) {
    for (RawVertex& vertex : raw.vertices) vertex.position += offset;
    for (RawCamera& camera : raw.cameras) camera.origin += offset;
    for (RawLight& light : raw.lights) light.position += offset;
    return raw;
}

RawScene withLight(RawScene raw, int exponent) {
    const double factor = std::ldexp(1.0, exponent);
    for (RawMaterial& material : raw.materials) material.emittedRadiance *= factor;
    for (RawLight& light : raw.lights) light.emission *= factor;
    return raw;
}

}  // namespace manylight::stability
