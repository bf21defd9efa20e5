// What this scene does not need, decided once, in one place, each time with the reason.
#pragma once

#include "engine/scene/scene.h"

#include <string>
#include <vector>

namespace manylight {

/// One thing left out (or kept) and why; `savedBytes` of device memory.
struct PlanDecision {
    std::string what;
    bool leftOut = false;
    std::string reason;
    uint64_t savedBytes = 0;
};

struct ScenePlan {
    bool textured = true;        // uvs, texels and their lookups
    uint32_t uvSets = 2;         // sets of uvs that are kept, at least 1
    bool shadingNormals = true;  // interpolated normals and the light paths' correction for them
    bool normalMapped = true;    // normals tilted by textures
    bool glossy = true;          // reflection that depends on directions, in shading and in the VPLs
    bool alphaTested = true;     // surfaces that let some light through: asked at every hit of a ray
    bool culled = true;          // back faces that the camera looks through
    bool vertexColours = true;
    bool emissionTextured = true;   // emission that varies over a triangle, and unlit materials
    bool areaLights = true;         // samples of emissive triangles and of the environment for direct light
    bool environmentMapped = true;  // surroundings that differ with the direction
    bool manyEmitters = true;       // more than one to choose from
    bool lightPaths = true;         // any light at all, and surfaces to send it to
    std::vector<PlanDecision> decisions;
};

/// `everything` (--plan off) leaves nothing out; the picture is the same.
ScenePlan planScene(const Scene& scene, bool everything = false);

/// One line a decision, for --explain.
std::string explain(const ScenePlan& plan);
Json toJson(const ScenePlan& plan);

}  // namespace manylight
