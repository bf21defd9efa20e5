// Splits a polygon into triangles.
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace manylight {

/// Fills `triangles` with corner numbers of size - 2 triangles that keep the polygon's winding: a fan from corner 0 if
/// the polygon is convex, ears otherwise. Returns false if it had to guess (self-intersecting, or concave with
/// thousands of corners); the triangles then still use every corner.
bool triangulate(std::span<const glm::dvec3> corners, std::vector<std::array<uint32_t, 3>>& triangles);

}  // namespace manylight
