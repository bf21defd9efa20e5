#include "engine/scene/triangulate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace manylight {
namespace {

// Cutting ears takes cubic time at worst.
constexpr size_t kMostCornersForEars = 1024;

/// Newell's normal: twice the vector area, right for any planar polygon.
glm::dvec3 vectorArea(std::span<const glm::dvec3> corners) {
    glm::dvec3 sum(0.0);
    for (size_t i = 1; i + 1 < corners.size(); ++i)
        sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return sum;
}

/// Projects along the normal's largest component, mirrored if needed so that the polygon is counter-clockwise.
std::vector<glm::dvec2> projected(std::span<const glm::dvec3> corners, const glm::dvec3& normal) {
    const glm::dvec3 size = glm::abs(normal);
    const int dropped = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int first = (dropped + 1) % 3;
    const int second = (dropped + 2) % 3;
    const double mirror = normal[dropped] < 0.0 ? -1.0 : 1.0;
    std::vector<glm::dvec2> flat;
    flat.reserve(corners.size());
    for (const glm::dvec3& corner : corners) {
        const glm::dvec3 p = corner - corners[0];
        flat.emplace_back(mirror * p[first], p[second]);
    }
    return flat;
}

/// Twice the signed area of a triangle: positive for a left turn.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool isConvex(const std::vector<glm::dvec2>& flat) {
    const size_t n = flat.size();
    for (size_t i = 0; i < n; ++i)
        if (turn(flat[i], flat[(i + 1) % n], flat[(i + 2) % n]) < 0.0) return false;
    return true;
}

/// Whether corner `ear` of the remaining outline can be cut off: it turns left and no other corner lies inside.
bool isEar(const std::vector<glm::dvec2>& flat, const std::vector<uint32_t>& outline, size_t ear) {
    const size_t n = outline.size();
    const glm::dvec2& a = flat[outline[(ear + n - 1) % n]];
    const glm::dvec2& b = flat[outline[ear]];
    const glm::dvec2& c = flat[outline[(ear + 1) % n]];
    if (turn(a, b, c) < 0.0) return false;
    for (const uint32_t other : outline) {
        const glm::dvec2& p = flat[other];
        if (p == a || p == b || p == c) continue;
        if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return false;
    }
    return true;
}

void addFan(const std::vector<uint32_t>& outline, std::vector<std::array<uint32_t, 3>>& triangles) {
    for (size_t i = 1; i + 1 < outline.size(); ++i) triangles.push_back({outline[0], outline[i], outline[i + 1]});
}

bool cutEars(const std::vector<glm::dvec2>& flat, std::vector<uint32_t> outline,
             std::vector<std::array<uint32_t, 3>>& triangles) {
    while (outline.size() > 3) {
        const size_t n = outline.size();
        size_t ear = 0;
        while (ear < n && !isEar(flat, outline, ear)) ++ear;
        if (ear == n) break;
        triangles.push_back({outline[(ear + n - 1) % n], outline[ear], outline[(ear + 1) % n]});
        outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    const bool foundAll = outline.size() == 3;
    addFan(outline, triangles);
    return foundAll;
}

}  // namespace

bool triangulate(std::span<const glm::dvec3> corners, std::vector<std::array<uint32_t, 3>>& triangles) {
    triangles.clear();
    if (corners.size() == 3) {
        triangles.push_back({0, 1, 2});
        return true;
    }
    std::vector<uint32_t> outline(corners.size());
    std::iota(outline.begin(), outline.end(), 0u);
    const std::vector<glm::dvec2> flat = projected(corners, vectorArea(corners));
    if (isConvex(flat) || corners.size() > kMostCornersForEars) {
        addFan(outline, triangles);
        return isConvex(flat);
    }
    return cutEars(flat, std::move(outline), triangles);
}

}  // namespace manylight
