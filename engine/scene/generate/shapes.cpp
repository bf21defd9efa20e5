#include "engine/scene/generate/shapes.h"

#include <cmath>

#include "engine/core/check.h"
#include "shaders/shared/constants.h"

namespace manylight {

namespace {

/// Eight corners; bit 0 of the index chooses x, bit 1 y, bit 2 z.
std::array<uint32_t, 8> addBoxCorners(Mesh& mesh, const Placement& place, const glm::dvec3& low, const glm::dvec3& high,
                                      double topInset) {
    std::array<uint32_t, 8> corner{};
    for (uint32_t i = 0; i < 8; ++i) {
        const double inset = i & 2u ? topInset : 0.0;
        corner[i] = addPosition(mesh, place.point({i & 1u ? high.x - inset : low.x + inset, i & 2u ? high.y : low.y,
                                                   i & 4u ? high.z - inset : low.z + inset}));
    }
    return corner;
}

void addBoxSides(Mesh& mesh, const std::array<uint32_t, 8>& c, uint32_t material) {
    addQuad(mesh, material, c[0], c[2], c[3], c[1]);  // -z
    addQuad(mesh, material, c[4], c[5], c[7], c[6]);  // +z
    addQuad(mesh, material, c[0], c[4], c[6], c[2]);  // -x
    addQuad(mesh, material, c[1], c[3], c[7], c[5]);  // +x
}

/// One vertex per segment around the axis, or a single one on it.
std::vector<uint32_t> addCircle(Mesh& mesh, const Placement& place, const glm::dvec2& at, uint32_t segments) {
    if (at.x <= 0.0) return {addPosition(mesh, place.point({0.0, at.y, 0.0}))};
    std::vector<uint32_t> circle(segments);
    for (uint32_t i = 0; i < segments; ++i) {
        const double angle = 2.0 * double{shared::kPi} * i / segments;
        circle[i] = addPosition(mesh, place.point({at.x * std::cos(angle), at.y, at.x * std::sin(angle)}));
    }
    return circle;
}

std::vector<uint32_t> addCircleNormals(Mesh& mesh, const Placement& place, const glm::dvec2& normal,
                                       uint32_t segments) {
    std::vector<uint32_t> circle(segments);
    for (uint32_t i = 0; i < segments; ++i) {
        const double angle = 2.0 * double{shared::kPi} * i / segments;
        circle[i] =
            addNormal(mesh, place.direction({normal.x * std::cos(angle), normal.y, normal.x * std::sin(angle)}));
    }
    return circle;
}

/// Outward normal of one step of a profile.
glm::dvec2 stepNormal(const glm::dvec2& from, const glm::dvec2& to) {
    return glm::normalize(glm::dvec2(to.y - from.y, from.x - to.x));
}

bool hasCrease(const glm::dvec2& normal, const glm::dvec2& neighbour) {
    constexpr double kCosCrease = 0.7;
    return glm::dot(normal, neighbour) < kCosCrease;
}

struct LatheRing {
    const std::vector<uint32_t>& positions;
    const std::vector<uint32_t>& normals;
    uint32_t positionAt(uint32_t i) const { return positions[i % positions.size()]; }
    uint32_t normalAt(uint32_t i) const { return normals[i % normals.size()]; }
};

/// Joins two rings; a ring that is a single point on the axis gives triangles.
void addBand(Mesh& mesh, const LatheRing& lower, const LatheRing& upper, uint32_t segments, uint32_t material) {
    for (uint32_t i = 0; i < segments; ++i) {
        MeshFace face{.material = material};
        uint32_t corner = 0;
        const auto add = [&](const LatheRing& ring, uint32_t k) {
            face.position[corner] = ring.positionAt(k);
            face.normal[corner++] = ring.normalAt(k);
        };
        add(lower, i);
        add(upper, i);
        if (upper.positions.size() > 1) add(upper, i + 1);
        if (lower.positions.size() > 1) add(lower, i + 1);
        mesh.faces.push_back(face);
    }
}

}  // namespace

void addBox(Mesh& mesh, const Placement& place, const glm::dvec3& low, const glm::dvec3& high, uint32_t material) {
    const std::array<uint32_t, 8> c = addBoxCorners(mesh, place, low, high, 0.0);
    addBoxSides(mesh, c, material);
    addQuad(mesh, material, c[0], c[1], c[5], c[4]);  // -y
    addQuad(mesh, material, c[2], c[6], c[7], c[3]);  // +y
}

void addPavingStone(Mesh& mesh, const Placement& place, const glm::dvec3& low, const glm::dvec3& high, double bevel,
                    uint32_t material) {
    const std::array<uint32_t, 8> c = addBoxCorners(mesh, place, low, high, bevel);
    addBoxSides(mesh, c, material);
    addQuad(mesh, material, c[2], c[6], c[7], c[3]);
}

void addLathe(Mesh& mesh, const Placement& place, const LatheProfile& profile, uint32_t segments, uint32_t material) {
    MANYLIGHT_CHECK(segments >= 3u);
    LatheProfile closed = profile;
    if (closed.front().x > 0.0) closed.insert(closed.begin(), {0.0, closed.front().y});
    if (closed.back().x > 0.0) closed.push_back({0.0, closed.back().y});

    std::vector<std::vector<uint32_t>> rings;
    for (const glm::dvec2& at : closed) rings.push_back(addCircle(mesh, place, at, segments));

    const size_t steps = closed.size() - 1;
    std::vector<uint32_t> lower;
    std::vector<uint32_t> upper;
    for (size_t k = 0; k < steps; ++k) {
        const glm::dvec2 own = stepNormal(closed[k], closed[k + 1]);
        const glm::dvec2 below = k > 0 ? stepNormal(closed[k - 1], closed[k]) : own;
        const glm::dvec2 above = k + 1 < steps ? stepNormal(closed[k + 1], closed[k + 2]) : own;
        const bool smoothFromBelow = k > 0 && !hasCrease(own, below);
        lower = smoothFromBelow ? upper : addCircleNormals(mesh, place, own, segments);
        upper = addCircleNormals(mesh, place, hasCrease(own, above) ? own : own + above, segments);
        addBand(mesh, {rings[k], lower}, {rings[k + 1], upper}, segments, material);
    }
}

void addSphere(Mesh& mesh, const Placement& place, double radius, double halfHeight, uint32_t segments,
               uint32_t material) {
    const uint32_t rings = std::max(2u, segments / 2);
    LatheProfile profile{{0.0, -halfHeight}};
    for (uint32_t i = 1; i < rings; ++i) {
        const double angle = double{shared::kPi} * i / rings;
        profile.push_back({radius * std::sin(angle), -halfHeight * std::cos(angle)});
    }
    profile.push_back({0.0, halfHeight});
    addLathe(mesh, place, profile, segments, material);
}

void addRectangularRing(Mesh& mesh, const glm::dvec2& half, const std::vector<glm::dvec2>& profile, uint32_t material) {
    constexpr std::array<glm::dvec2, 4> kCorners{{{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}};
    const auto count = static_cast<uint32_t>(profile.size());
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (const glm::dvec2& corner : kCorners)
        for (const glm::dvec2& p : profile)
            addPosition(mesh, {corner.x * (half.x + p.x), p.y, corner.y * (half.y + p.x)});

    for (uint32_t side = 0; side < 4; ++side) {
        const uint32_t here = first + side * count;
        const uint32_t there = first + (side + 1) % 4 * count;
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t next = (i + 1) % count;
            addQuad(mesh, material, here + i, there + i, there + next, here + next);
        }
    }
}

void addSlab(Mesh& mesh, const Placement& place, const std::vector<glm::dvec2>& lower,
             const std::vector<glm::dvec2>& upper, double thickness, uint32_t material) {
    MANYLIGHT_CHECK(lower.size() == upper.size());
    struct Column {
        uint32_t frontLow, frontHigh, backLow, backHigh;
    };
    std::vector<Column> columns;
    for (size_t i = 0; i < lower.size(); ++i) {
        const auto add = [&](const glm::dvec2& p, double z) { return addPosition(mesh, place.point({p.x, p.y, z})); };
        columns.push_back({add(lower[i], 0), add(upper[i], 0), add(lower[i], thickness), add(upper[i], thickness)});
    }
    for (size_t i = 0; i + 1 < columns.size(); ++i) {
        const Column& a = columns[i];
        const Column& b = columns[i + 1];
        addQuad(mesh, material, a.frontLow, a.frontHigh, b.frontHigh, b.frontLow);
        addQuad(mesh, material, a.backLow, b.backLow, b.backHigh, a.backHigh);
        addQuad(mesh, material, a.frontHigh, a.backHigh, b.backHigh, b.frontHigh);
        addQuad(mesh, material, a.frontLow, b.frontLow, b.backLow, a.backLow);
    }
    const Column& a = columns.front();
    const Column& b = columns.back();
    addQuad(mesh, material, a.frontLow, a.backLow, a.backHigh, a.frontHigh);
    addQuad(mesh, material, b.frontLow, b.frontHigh, b.backHigh, b.backLow);
}

}  // namespace manylight
