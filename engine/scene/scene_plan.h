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
    bool canBeKept = true;  // by --plan off; not what is not there
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
    bool pixelVariance = true;      // how far the frames of every pixel scatter
    bool cutOff = true;             // deferred: a picture of what the bound on the geometry term takes
    std::vector<PlanDecision> decisions;
};

/// `everything` (--plan off) leaves nothing out; the picture is the same. `keeps` (--plan-keeps) names one thing that
/// is kept though the scene does not need it: throws Error if there is no such decision.
ScenePlan planScene(const Scene& scene, bool everything = false, const std::string& keeps = {});

/// One line a decision, for --explain.
std::string explain(const ScenePlan& plan);
Json toJson(const ScenePlan& plan);

}  // namespace manylight
