#include "engine/scene/generate/showcase_mesh.h"

#include "shaders/shared/constants.h"

#include <algorithm>
#include <cmath>

namespace manylight::showcase {
namespace {

constexpr double kPi = double{shared::kPi};

/// Last-bit differences between mathematical libraries vanish.
glm::vec3 rounded(const glm::dvec3& v) { return glm::vec3(glm::round(v * 1e5) / 1e5 + 0.0); }

glm::dvec3 normalAt(const Patch& patch, double u, double v) {
    constexpr double kStep = 1e-4;
    // Edges may be poles, where a patch has no direction.
    const double x = std::clamp(u, 10 * kStep, 1.0 - 10 * kStep);
    const double y = std::clamp(v, 10 * kStep, 1.0 - 10 * kStep);
    const glm::dvec3 right = patch(x + kStep, y) - patch(x - kStep, y);
    const glm::dvec3 down = patch(x, y + kStep) - patch(x, y - kStep);
    return glm::normalize(glm::cross(down, right));
}

Surface& surfaceOf(Solid& solid, uint32_t material) {
    const auto found = std::ranges::find(solid, material, &Surface::material);
    if (found != solid.end()) return *found;
    solid.push_back({.material = material, .corners = {}, .indices = {}});
    return solid.back();
}

void addTriangle(Surface& surface, uint32_t a, uint32_t b, uint32_t c) {
    const auto& p = surface.corners;
    const glm::vec3 across = glm::cross(p[b].position - p[a].position, p[c].position - p[a].position);
    if (glm::length(across) > 1e-9f) surface.indices.insert(surface.indices.end(), {a, b, c});  // none at a pole
}

void addCells(Surface& surface, uint32_t first, const glm::uvec2& cells) {
    for (uint32_t y = 0; y < cells.y; ++y)
        for (uint32_t x = 0; x < cells.x; ++x) {
            const uint32_t corner = first + y * (cells.x + 1) + x;
            const uint32_t below = corner + cells.x + 1;
            addTriangle(surface, corner, below, below + 1);
            addTriangle(surface, corner, below + 1, corner + 1);
        }
}

}  // namespace

void addPatch(Solid& solid, const Cover& cover, const glm::uvec2& cells, const glm::dvec2& metres, const Patch& patch) {
    Surface& surface = surfaceOf(solid, cover.material);
    const auto first = static_cast<uint32_t>(surface.corners.size());
    for (uint32_t y = 0; y <= cells.y; ++y)
        for (uint32_t x = 0; x <= cells.x; ++x) {
            const glm::dvec2 at(static_cast<double>(x) / cells.x, static_cast<double>(y) / cells.y);
            surface.corners.push_back({rounded(patch(at.x, at.y)), rounded(normalAt(patch, at.x, at.y)),
                                       glm::vec2(at * metres), glm::vec2(at),
                                       glm::vec4(glm::vec3(cover.colour), 1.0f)});
        }
    addCells(surface, first, cells);
}

void addPanel(Solid& solid, const Cover& cover, const Plane& plane, const glm::dvec2& low, const glm::dvec2& high) {
    Surface& surface = surfaceOf(solid, cover.material);
    const auto first = static_cast<uint32_t>(surface.corners.size());
    const glm::vec3 normal = rounded(glm::cross(plane.down, plane.right));
    for (uint32_t i = 0; i < 4; ++i) {
        const glm::dvec2 unit(i % 2, i / 2);
        const glm::dvec2 at = glm::mix(low, high, unit);
        surface.corners.push_back(
            {rounded(plane.at(at)), normal, glm::vec2(at), glm::vec2(unit), glm::vec4(glm::vec3(cover.colour), 1.0f)});
    }
    addCells(surface, first, {1, 1});
}

void addBlock(Solid& solid, const Cover& cover, const glm::dvec3& low, const glm::dvec3& high) {
    const glm::dvec3 x(1, 0, 0);
    const glm::dvec3 y(0, 1, 0);
    const glm::dvec3 z(0, 0, 1);
    const glm::dvec3 size = high - low;
    const auto add = [&](const Plane& plane, double width, double height) {
        addPanel(solid, cover, plane, {0, 0}, {width, height});
    };
    add({{low.x, high.y, high.z}, x, -y}, size.x, size.y);
    add({{high.x, high.y, low.z}, -x, -y}, size.x, size.y);
    add({{high.x, high.y, high.z}, -z, -y}, size.z, size.y);
    add({{low.x, high.y, low.z}, z, -y}, size.z, size.y);
    add({{low.x, high.y, low.z}, x, z}, size.x, size.z);
    add({{low.x, low.y, high.z}, x, -z}, size.x, size.z);
}

void addRoundedBlock(Solid& solid, const Cover& cover, const glm::dvec3& low, const glm::dvec3& high, double radius,
                     uint32_t cells) {
    const glm::dvec3 half = 0.5 * (high - low);
    const glm::dvec3 center = 0.5 * (high + low);
    const glm::dvec3 inner = half - radius;
    const uint32_t count = 2 * cells + 1;
    // Cells of equal number, narrow where it is round and one wide between.
    const auto along = [&](double t, double size) {
        const double cell = t * count;
        if (cell <= cells) return -size + radius * cell / cells;
        if (cell >= cells + 1) return size - radius * (count - cell) / cells;
        return glm::mix(-(size - radius), size - radius, cell - cells);
    };
    const auto addSide = [&](const glm::dvec3& right, const glm::dvec3& down) {
        const glm::dvec3 out = glm::cross(down, right);
        const glm::dvec3 to(glm::dot(glm::abs(right), half), glm::dot(glm::abs(down), half),
                            glm::dot(glm::abs(out), half));
        addPatch(solid, cover, glm::uvec2(count), 2.0 * glm::dvec2(to), [&](double u, double v) {
            const glm::dvec3 p = along(u, to.x) * right + along(v, to.y) * down + to.z * out;
            const glm::dvec3 nearest = glm::clamp(p, -inner, inner);
            return center + nearest + radius * glm::normalize(p - nearest);
        });
    };
    for (const double side : {1.0, -1.0}) {
        addSide({side, 0, 0}, {0, -1, 0});
        addSide({0, 0, -side}, {0, -1, 0});
        addSide({1, 0, 0}, {0, 0, side});
    }
}

void addTurned(Solid& solid, const Cover& cover, const glm::dvec3& foot, const LatheProfile& profile,
               const glm::uvec2& cells) {
    double length = 0.0;
    double widest = 0.0;
    for (size_t i = 0; i + 1 < profile.size(); ++i) {
        length += glm::distance(profile[i], profile[i + 1]);
        widest = std::max({widest, profile[i].x, profile[i + 1].x});
    }
    const auto at = [&](double index) {
        const double last = static_cast<double>(profile.size() - 1);
        return profile[static_cast<size_t>(std::clamp(index, 0.0, last))];
    };
    addPatch(solid, cover, cells, {2 * kPi * widest, length}, [&](double u, double v) {
        const double place = std::clamp(v, 0.0, 1.0) * static_cast<double>(profile.size() - 1);
        const double knot = std::min(std::floor(place), static_cast<double>(profile.size() - 2));
        const double t = place - knot;
        // Catmull and Rom's curve through the profile.
        const glm::dvec2 a = at(knot - 1);
        const glm::dvec2 b = at(knot);
        const glm::dvec2 c = at(knot + 1);
        const glm::dvec2 d = at(knot + 2);
        const glm::dvec2 p =
            0.5 * (2.0 * b + t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a))));
        const double angle = 2 * kPi * u;
        return foot + glm::dvec3(std::max(p.x, 0.0) * std::sin(angle), p.y, std::max(p.x, 0.0) * std::cos(angle));
    });
}

void addRod(Solid& solid, const Cover& cover, const glm::dvec3& from, const glm::dvec3& to, double radius) {
    const glm::dvec3 axis = glm::normalize(from - to);
    const glm::dvec3 side = std::abs(axis.y) > 0.9 ? glm::dvec3(1, 0, 0) : glm::normalize(glm::cross(axis, {0, 1, 0}));
    const glm::dvec3 front = glm::cross(side, axis);
    addPatch(solid, cover, {12, 1}, {2 * kPi * radius, glm::distance(from, to)}, [&](double u, double v) {
        const double angle = 2 * kPi * u;
        return glm::mix(from, to, v) + radius * (std::sin(angle) * side + std::cos(angle) * front);
    });
}

void addBall(Solid& solid, const Cover& cover, const glm::dvec3& center, const glm::dvec3& radii,
             const glm::uvec2& cells) {
    addPatch(solid, cover, cells, {2 * kPi * radii.x, kPi * radii.y}, [&](double u, double v) {
        const double around = 2 * kPi * u;
        const double down = kPi * v;
        return center +
               radii * glm::dvec3(std::sin(down) * std::sin(around), std::cos(down), std::sin(down) * std::cos(around));
    });
}

void addPillow(Solid& solid, const Cover& cover, const glm::dvec3& half, uint32_t cells) {
    for (const double side : {1.0, -1.0})
        addPatch(solid, cover, glm::uvec2(cells), {2 * half.x, 2 * half.y}, [&](double u, double v) {
            const double x = kPi * (u - 0.5);
            const double y = kPi * (0.5 - v);
            // Its corners are drawn out a little.
            const double slim = 1.0 - 0.08 * (std::cos(x) + std::cos(y));
            return half * glm::dvec3(side * slim * std::sin(x), slim * std::sin(y), side * std::cos(x) * std::cos(y));
        });
}

size_t triangleCount(const Solid& solid) {
    size_t count = 0;
    for (const Surface& surface : solid) count += surface.indices.size() / 3;
    return count;
}

}  // namespace manylight::showcase
