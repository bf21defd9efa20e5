// Meshes of the showcase: patches with normals, two sets of texture coordinates and colours.
#pragma once

#include "engine/scene/generate/shapes.h"

#include <functional>

namespace manylight::showcase {

struct Corner {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec2 uv;   // metres
    glm::vec2 uv1;  // once over a patch
    glm::vec4 colour;
};

struct Surface {
    uint32_t material = 0;
    std::vector<Corner> corners;
    std::vector<uint32_t> indices;
};

/// One surface for each of its materials.
using Solid = std::vector<Surface>;

/// How a patch is covered.
struct Cover {
    uint32_t material = 0;
    glm::dvec3 colour{1.0};
};

/// A point of a smooth patch; u runs to the right in [0, 1] and v down, seen from the front.
using Patch = std::function<glm::dvec3(double u, double v)>;

/// `metres` is the size of the patch, in which its first texture coordinates count.
void addPatch(Solid& solid, const Cover& cover, const glm::uvec2& cells, const glm::dvec2& metres, const Patch& patch);

/// A plane seen from its front: unit vectors to the right and down.
struct Plane {
    glm::dvec3 origin;
    glm::dvec3 right;
    glm::dvec3 down;
    glm::dvec3 at(const glm::dvec2& p) const { return origin + p.x * right + p.y * down; }
};

/// The rectangle between two points of a plane, which are its texture coordinates too.
void addPanel(Solid& solid, const Cover& cover, const Plane& plane, const glm::dvec2& low, const glm::dvec2& high);

/// A box with sharp edges.
void addBlock(Solid& solid, const Cover& cover, const glm::dvec3& low, const glm::dvec3& high);

/// A box whose edges are rounded, with `cells` across a rounding.
void addRoundedBlock(Solid& solid, const Cover& cover, const glm::dvec3& low, const glm::dvec3& high, double radius,
                     uint32_t cells);

/// A smooth solid of revolution about a vertical axis. The profile runs down on the outside.
void addTurned(Solid& solid, const Cover& cover, const glm::dvec3& foot, const LatheProfile& profile,
               const glm::uvec2& cells);

/// A rod without ends.
void addRod(Solid& solid, const Cover& cover, const glm::dvec3& from, const glm::dvec3& to, double radius);

void addBall(Solid& solid, const Cover& cover, const glm::dvec3& center, const glm::dvec3& radii,
             const glm::uvec2& cells);

/// A pillow upright about the origin, its larger sides towards +z and -z.
void addPillow(Solid& solid, const Cover& cover, const glm::dvec3& half, uint32_t cells);

size_t triangleCount(const Solid& solid);

}  // namespace manylight::showcase
