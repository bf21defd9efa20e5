// Closed solids for the scene generators. Every shape adds faces turned outwards to the object that is open.
#pragma once

#include <vector>

#include "engine/scene/generate/mesh.h"

namespace manylight {

/// An axis-parallel box of the local frame: eight vertices, six quads.
void addBox(Mesh& mesh, const Placement& place, const glm::dvec3& low, const glm::dvec3& high, uint32_t material);

/// A paving stone: a box without its bottom whose upper edges are cut by `bevel` (an open shape).
void addPavingStone(Mesh& mesh, const Placement& place, const glm::dvec3& low, const glm::dvec3& high, double bevel,
                    uint32_t material);

/// A point of a lathe's profile: distance from the axis and height.
using LatheProfile = std::vector<glm::dvec2>;

/// A solid of revolution about the local y axis, `segments` (>= 3) around. The profile runs with the solid on its
/// left-hand side when the radius points right: upwards along an outer wall. It is closed by discs where it does not
/// begin or end on the axis. Smooth where the profile bends by less than about 45 degrees.
void addLathe(Mesh& mesh, const Placement& place, const LatheProfile& profile, uint32_t segments, uint32_t material);

/// A sphere, or a spheroid if the radii differ, with its centre at the placement's origin.
void addSphere(Mesh& mesh, const Placement& place, double radius, double halfHeight, uint32_t segments,
               uint32_t material);

/// A closed moulding around a rectangle of half sizes `half` (x, z): `profile` is a counter-clockwise polygon of
/// (offset outwards from the rectangle, height), swept around four mitred corners.
void addRectangularRing(Mesh& mesh, const glm::dvec2& half, const std::vector<glm::dvec2>& profile, uint32_t material);

/// An upright slab between z = 0 and z = `thickness` whose front (towards -z) has the outline between `lower` and
/// `upper`: two polylines of the same length that run from left to right and face each other point by point.
void addSlab(Mesh& mesh, const Placement& place, const std::vector<glm::dvec2>& lower,
             const std::vector<glm::dvec2>& upper, double thickness, uint32_t material);

}  // namespace manylight
