#include "engine/accel/ray_sets.h"

#include "engine/accel/embree_reference.h"
#include "shaders/shared/constants.h"
#include "shaders/shared/ray_offset.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace manylight {

namespace {

constexpr float kFarAway = 1e10f;

float uniform(std::mt19937_64& random) { return static_cast<float>(random() >> 40) * 0x1p-24f; }

uint32_t everySecondBit(uint32_t bits) {
    uint32_t result = 0;
    for (uint32_t i = 0; i < 16; ++i) result |= (bits >> (2 * i) & 1u) << i;
    return result;
}

glm::vec3 cosineDirection(const glm::vec3& normal, float u0, float u1) {
    const float radius = std::sqrt(u0);
    const float angle = 2.0f * shared::kPi * u1;
    const glm::vec3 helper = std::abs(normal.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 tangent = glm::normalize(glm::cross(helper, normal));
    const glm::vec3 bitangent = glm::cross(normal, tangent);
    return radius * std::cos(angle) * tangent + radius * std::sin(angle) * bitangent + std::sqrt(1.0f - u0) * normal;
}

}  // namespace

RaySet primaryRays(const Camera& camera, uint32_t width, uint32_t height) {
    const float halfHeight = std::tan(camera.verticalFov * 0.5f);
    const float halfWidth = halfHeight * static_cast<float>(width) / static_cast<float>(height);
    const glm::vec3 right = glm::cross(camera.forward, camera.up);
    RaySet rays;
    rays.reserve(size_t{width} * height);
    uint32_t side = 1;
    while (side < std::max(width, height)) side *= 2;
    for (uint64_t i = 0; i < uint64_t{side} * side; ++i) {
        const uint32_t x = everySecondBit(static_cast<uint32_t>(i));
        const uint32_t y = everySecondBit(static_cast<uint32_t>(i >> 1));
        if (x >= width || y >= height) continue;
        const float u = 2.0f * (static_cast<float>(x) + 0.5f) / static_cast<float>(width) - 1.0f;
        const float v = 1.0f - 2.0f * (static_cast<float>(y) + 0.5f) / static_cast<float>(height);
        const glm::vec3 direction = camera.forward + u * halfWidth * right + v * halfHeight * camera.up;
        rays.push_back({camera.origin, kFarAway, glm::normalize(direction), 0.0f});
    }
    return rays;
}

std::vector<SurfacePoint> surfacePoints(const Scene& scene, const RaySet& rays) {
    const EmbreeReference embree(scene);
    std::vector<SurfacePoint> points;
    for (const shared::RayQuery& ray : rays) {
        const std::optional<ClosestHit> hit = embree.closest(ray);
        if (!hit) continue;
        const auto& corner = scene.triangles[hit->triangle].vertex;
        const glm::vec2 b = hit->barycentrics;
        const glm::vec3 position = (1.0f - b.x - b.y) * scene.vertices[corner[0]].position +
                                   b.x * scene.vertices[corner[1]].position + b.y * scene.vertices[corner[2]].position;
        const glm::vec3 normal = glm::normalize(hit->normal);
        points.push_back({position, glm::dot(normal, ray.direction) > 0.0f ? -normal : normal});
    }
    return points;
}

std::vector<SurfacePoint> randomSurfacePoints(const Scene& scene, uint32_t count, uint64_t seed) {
    std::vector<double> areaUpTo;
    double area = 0.0;
    for (const Triangle& triangle : scene.triangles) {
        const glm::dvec3 a = scene.vertices[triangle.vertex[0]].position;
        const glm::dvec3 b = scene.vertices[triangle.vertex[1]].position;
        const glm::dvec3 c = scene.vertices[triangle.vertex[2]].position;
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
        areaUpTo.push_back(area);
    }
    std::vector<SurfacePoint> points;
    if (!(area > 0.0)) return points;
    std::mt19937_64 random(seed);
    for (uint32_t i = 0; i < count; ++i) {
        const auto found = std::ranges::upper_bound(areaUpTo, static_cast<double>(uniform(random)) * area);
        const auto& corner = scene.triangles[static_cast<size_t>(found - areaUpTo.begin())].vertex;
        const glm::vec3 a = scene.vertices[corner[0]].position;
        const glm::vec3 b = scene.vertices[corner[1]].position;
        const glm::vec3 c = scene.vertices[corner[2]].position;
        const float root = std::sqrt(uniform(random));
        const float second = uniform(random) * root;
        points.push_back(
            {(1.0f - root) * a + (root - second) * b + second * c, glm::normalize(glm::cross(b - a, c - a))});
    }
    return points;
}

shared::RayQuery shadowRay(const SurfacePoint& point, const SurfacePoint& light) {
    const glm::vec3 along = light.position - point.position;
    const auto towards = [](glm::vec3 normal, glm::vec3 direction) {
        return glm::dot(normal, direction) < 0.0f ? -normal : normal;
    };
    const glm::vec3 start = shared::offsetPoint(point.position, towards(point.normal, along));
    const glm::vec3 end = shared::offsetPoint(light.position, towards(light.normal, -along));
    return {start, 1.0f, end - start, 0.0f};
}

RaySet coherentShadowRays(const std::vector<SurfacePoint>& points, const SurfacePoint& light) {
    RaySet rays;
    rays.reserve(points.size());
    for (const SurfacePoint& point : points) rays.push_back(shadowRay(point, light));
    return rays;
}

RaySet incoherentShadowRays(const std::vector<SurfacePoint>& points, const std::vector<SurfacePoint>& lights,
                            uint64_t seed) {
    std::mt19937_64 random(seed);
    RaySet rays;
    rays.reserve(points.size());
    for (const SurfacePoint& point : points) rays.push_back(shadowRay(point, lights[random() % lights.size()]));
    return rays;
}

RaySet diffuseBounceRays(const std::vector<SurfacePoint>& points, uint64_t seed) {
    std::mt19937_64 random(seed);
    RaySet rays;
    rays.reserve(points.size());
    for (const SurfacePoint& point : points) {
        const float u0 = uniform(random);
        const float u1 = uniform(random);
        const glm::vec3 direction = cosineDirection(point.normal, u0, u1);
        rays.push_back({shared::offsetPoint(point.position, point.normal), kFarAway, direction, 0.0f});
    }
    return rays;
}

}  // namespace manylight
