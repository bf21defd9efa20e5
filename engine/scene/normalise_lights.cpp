#include "engine/scene/normalise_parts.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

/// Unit vector, or zero if the direction is zero or not finite.
glm::dvec3 unitOrZero(const glm::dvec3& v) {
    const double length = std::hypot(v.x, v.y, v.z);
    return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
}

bool isFiniteInFrame(const Scene& scene, const glm::dvec3& point) {
    const glm::vec3 p = normalisedPoint(scene.frame, point);
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

glm::dvec3 anyPerpendicular(const glm::dvec3& unit) {
    const glm::dvec3 axis = std::abs(unit.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    return glm::normalize(axis - glm::dot(axis, unit) * unit);
}

}  // namespace

void convertLights(const RawScene& raw, Scene& scene) {
    for (const RawLight& source : raw.lights) {
        const bool hasPosition = source.type == LightType::Point || source.type == LightType::Spot;
        const bool hasDirection = source.type == LightType::Directional || source.type == LightType::Spot;
        const glm::dvec3 direction = unitOrZero(source.direction);
        if ((hasPosition && !isFiniteInFrame(scene, source.position)) || (hasDirection && direction == glm::dvec3(0))) {
            scene.warnings.add("lights dropped: position or direction not usable", source.name);
            continue;
        }
        // I / d² is the radiance's share and d shrinks by 2^exponent, so I shrinks by 4^exponent.
        const double unitChange = hasPosition ? std::ldexp(1.0, -2 * scene.frame.exponent) : 1.0;
        Light light;
        light.type = source.type;
        light.name = source.name;
        if (hasPosition) light.position = normalisedPoint(scene.frame, source.position);
        if (hasDirection) light.direction = glm::vec3(direction);
        light.emission = repairedEmission(source.emission * unitChange, source.name, scene.warnings);
        light.cosCutoff = static_cast<float>(source.cosCutoff);
        light.cosBeam = static_cast<float>(source.cosBeam);
        if (hasPosition) light.range = static_cast<float>(std::ldexp(source.range, -scene.frame.exponent));
        if (light.type == LightType::Spot && light.cosCutoff >= 1.0f)
            scene.warnings.add("spot lights without light: cutoff narrower than single precision can tell",
                               source.name);
        scene.lights.push_back(std::move(light));
    }
}

void convertCameras(const RawScene& raw, Scene& scene) {
    for (const RawCamera& source : raw.cameras) {
        const glm::dvec3 forward = unitOrZero(source.forward);
        const bool isUsable = forward != glm::dvec3(0) && isFiniteInFrame(scene, source.origin) &&
                              source.verticalFov > 0.0 && std::tan(source.verticalFov / 2) > 0.0;
        if (!isUsable) {
            scene.warnings.add("cameras dropped: origin, direction or field of view not usable", source.name);
            continue;
        }
        const glm::dvec3 wanted = unitOrZero(source.up);
        glm::dvec3 up = unitOrZero(wanted - glm::dot(wanted, forward) * forward);
        if (glm::length(glm::cross(wanted, forward)) < 1e-9) {
            scene.warnings.add("cameras given another up vector: it was zero or along the view", source.name);
            up = anyPerpendicular(forward);
        }
        Camera camera;
        camera.name = source.name;
        camera.origin = normalisedPoint(scene.frame, source.origin);
        camera.forward = glm::vec3(forward);
        camera.up = glm::vec3(up);
        camera.verticalFov = static_cast<float>(source.verticalFov);
        camera.resolution = source.resolution;
        scene.cameras.push_back(std::move(camera));
    }
}

}  // namespace manylight
