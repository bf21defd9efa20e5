// What this scene does not need, decided once, in one place, each time with the reason.
#pragma once

#include "engine/scene/import_options.h"
#include "engine/scene/scene.h"

#include <span>
#include <string>
#include <vector>

namespace manylight {

// Left out until they are asked for.
inline constexpr const char* kPlanPixelVariance = "variance of pixels";
inline constexpr const char* kPlanCutOff = "picture of the light cut off";
inline constexpr const char* kPlanDisplay = "displayed picture after every frame";

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
    bool mipmapped = true;       // smaller versions of textures, for what the camera sees from afar
    uint32_t uvSets = 2;         // sets of uvs that are kept, at least 1
    bool shadingNormals = true;  // interpolated normals and the light paths' correction for them
    bool normalMapped = true;    // normals tilted by textures
    bool glossy = true;          // reflection that depends on directions, in shading and in the VPLs
    bool alphaTested = true;     // surfaces that let some light through: asked at every hit of a ray
    bool culled = true;          // back faces that the camera looks through
    bool vertexColours = true;
    bool emissionTextured = true;   // emission that varies over a triangle, and unlit materials
    bool instanced = true;          // two levels: meshes with a BVH each, and instances that put them into the scene
    bool stretched = true;          // instances that do not scale alike along all axes: normals need a matrix
    bool areaLights = true;         // samples of emissive triangles and of the environment for direct light
    bool environmentMapped = true;  // surroundings that differ with the direction
    bool manyEmitters = true;       // more than one to choose from
    bool lightPaths = true;         // any light at all, and surfaces to send it to
    bool pixelVariance = true;      // how far the frames of every pixel scatter
    bool cutOff = true;             // deferred: a picture of what the bound on the geometry term takes
    bool hardwareRays = false;      // the device traces rays, without BVH nodes; decided by who knows the device
    bool display = true;            // the displayed picture after every frame, not only when it is asked for
    std::vector<PlanDecision> decisions;
};

/// `everything` (--plan off) leaves nothing out; the picture is the same. `keeps` (--plan-keeps) names one thing that
/// is kept though the scene does not need it: throws Error if there is no such decision.
ScenePlan planScene(const Scene& scene, bool everything = false, const std::string& keeps = {});

/// Of what is left out until it is asked for: it is, or it no longer is.
void settle(ScenePlan& plan, const std::string& what, bool isAskedFor);

/// A mesh that could be shared, and how often it is shown.
struct RepeatedMesh {
    uint64_t triangles = 0;
    uint64_t uses = 0;
};

/// Auto shares meshes if the scene's geometry then takes half of the device memory at most and 16 MiB less: rays
/// through two levels are slower than through one.
SharingChoice chooseSharing(std::span<const RepeatedMesh> meshes, InstanceMode mode);

/// Of a scene that shares: is this mesh shared? Not if the instances would take more than the repeats.
bool isSharedWhere(const RepeatedMesh& mesh, InstanceMode mode);

/// One line a decision, for --explain.
std::string explain(const ScenePlan& plan);
Json toJson(const ScenePlan& plan);

}  // namespace manylight
