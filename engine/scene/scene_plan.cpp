#include "engine/scene/scene_plan.h"

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/scene/instances.h"
#include "engine/scene/mipmaps.h"
#include "shaders/shared/lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace manylight {
namespace {

constexpr const char* kNotAskedFor = "not asked for";

/// What is not left out whatever the scene needs.
struct Kept {
    bool everything = false;
    const std::string& one;
};

/// Notes the decision and returns whether the thing is needed.
bool decide(ScenePlan& plan, const Kept& kept, bool needed, const char* what, const std::string& reason,
            uint64_t savedBytes = 0) {
    const bool leftOut = !needed && !kept.everything && kept.one != what;
    const std::string why = needed || leftOut ? reason : kept.everything ? "--plan off" : "--plan-keeps";
    plan.decisions.push_back({what, leftOut, why, leftOut ? savedBytes : 0, true});
    return !leftOut;
}

void refuseUnknown(const ScenePlan& plan, const std::string& keeps) {
    std::string names;
    for (const PlanDecision& decision : plan.decisions) {
        if (keeps.empty() || (keeps == decision.what && decision.canBeKept)) return;
        if (decision.canBeKept) names += (names.empty() ? "" : ", ") + decision.what;
    }
    failUsage("--plan-keeps '{}': expected one of {}", keeps, names);
}

uint64_t texelBytes(const Scene& scene) {
    uint64_t bytes = 0;
    for (const Texture& texture : scene.textures) bytes += texture.rgba.size();
    return bytes;
}

bool isMipmapped(const Scene& scene, const TextureUse& use) {
    return scene.textures[static_cast<size_t>(use.texture)].isMipmapped;
}

std::string reasonOfMipmaps(const Scene& scene, bool textured, bool mipmapped) {
    if (!textured) return "no triangle's material has a texture";
    if (!mipmapped) return "no texture's sampler asks for them";
    uint64_t bytes = 0;
    for (const Texture& texture : scene.textures)
        if (texture.isMipmapped) bytes += 4 * texelsOfReduced(texture.width, texture.height);
    return fmt::format("a texture's sampler asks for them: they take up to {} bytes", bytes);
}

// What geometry takes on the device, about: corners, BVH nodes, material; a record and a node for an instance.
constexpr uint64_t kBytesPerTriangle = 72;
constexpr uint64_t kBytesPerInstance = 160;
constexpr uint64_t kLeastSaved = uint64_t{16} << 20;

int64_t savedBy(const RepeatedMesh& mesh) {
    return static_cast<int64_t>((mesh.uses - 1) * mesh.triangles * kBytesPerTriangle) -
           static_cast<int64_t>(mesh.uses * kBytesPerInstance);
}

bool isGlossy(const Material& material) { return material.metallic > 0.0f || material.specular != glm::vec3(0.0f); }

bool emits(const Material& material) { return material.emittedRadiance != glm::vec3(0.0f); }

size_t countEmitters(const Scene& scene) {
    const InstanceList list = listInstances(scene);
    std::vector<size_t> ofMesh;
    for (const SharedMesh& mesh : list.meshes) {
        const auto first = scene.triangles.begin() + mesh.firstTriangle;
        ofMesh.push_back(static_cast<size_t>(std::count_if(
            first, first + mesh.triangleCount, [&](const Triangle& t) { return emits(scene.materials[t.material]); })));
    }
    size_t count = scene.lights.size() + (scene.environment ? 1 : 0);
    for (const MeshInstance& instance : list.instances) count += ofMesh[instance.mesh];
    return count;
}

/// Scales alike along all axes, so that it turns normals as it turns directions?
bool scalesAlike(const glm::mat3& m) {
    const glm::vec3 squares{glm::dot(m[0], m[0]), glm::dot(m[1], m[1]), glm::dot(m[2], m[2])};
    const float largest = std::max({squares.x, squares.y, squares.z});
    const float smallest = std::min({squares.x, squares.y, squares.z});
    const float skew =
        std::max({std::abs(glm::dot(m[0], m[1])), std::abs(glm::dot(m[1], m[2])), std::abs(glm::dot(m[2], m[0]))});
    return largest - smallest <= 1e-5f * largest && skew <= 1e-5f * largest;
}

void planInstances(ScenePlan& plan, const Scene& scene, const Kept& kept) {
    const bool shares = !scene.instances.empty();
    // Not for --plan off: everything twice over makes shaders that a software driver compiles for a minute.
    plan.instanced = decide(plan, {false, kept.one}, shares, "two levels of rays", scene.sharing.reason);
    // Without triangles there is nothing that could be put anywhere.
    if (scene.triangles.empty()) plan.instanced = false;
    const bool stretched =
        std::any_of(scene.instances.begin(), scene.instances.end(),
                    [](const MeshInstance& instance) { return !scalesAlike(instance.sceneFromMesh); });
    // Not for --plan off: the same normals by another matrix would be rounded differently.
    plan.stretched = stretched;
    plan.decisions.push_back({"matrices of normals", !stretched,
                              stretched ? "an instance scales its axes differently"
                              : shares  ? "every instance scales its axes alike"
                                        : "no mesh is an instance",
                              0, false});
    plan.decisions.push_back({"repeated triangles", shares, scene.sharing.reason, scene.sharing.savedBytes, false});
}

}  // namespace

bool isSharedWhere(const RepeatedMesh& mesh, InstanceMode mode) {
    return mesh.uses > 1 && (mode == InstanceMode::Share || savedBy(mesh) > 0);
}

SharingChoice chooseSharing(std::span<const RepeatedMesh> meshes, InstanceMode mode) {
    if (mode == InstanceMode::Flatten) return {false, "meshes are repeated, as asked for", 0};
    uint64_t all = 0;
    uint64_t saved = 0;
    uint64_t shared = 0;
    for (const RepeatedMesh& mesh : meshes) {
        all += mesh.triangles * mesh.uses * kBytesPerTriangle;
        if (!isSharedWhere(mesh, mode)) continue;
        saved += static_cast<uint64_t>(std::max<int64_t>(savedBy(mesh), 0));
        ++shared;
    }
    if (shared == 0) return {false, "no mesh is shown twice", 0};
    if (mode == InstanceMode::Share)
        return {true, fmt::format("{} meshes are shown more than once, and sharing is asked for", shared), saved};
    if (saved < kLeastSaved) return {false, "repeating meshes takes less than 16 MiB more than sharing them", 0};
    if (2 * saved < all) return {false, "sharing meshes would save less than half of the geometry's memory", 0};
    return {true, fmt::format("{} meshes are shown more than once", shared), saved};
}

ScenePlan planScene(const Scene& scene, bool everything, const std::string& keeps) {
    ScenePlan plan;
    const Kept kept{everything, keeps};
    const auto usesMaterial = [&](auto&& predicate) {
        return std::any_of(scene.triangles.begin(), scene.triangles.end(),
                           [&](const Triangle& triangle) { return predicate(scene.materials[triangle.material]); });
    };

    const auto usesTexture = [&](auto&& accepts) {
        return usesMaterial([&](const Material& m) {
            return std::ranges::any_of(std::array{m.albedoTexture, m.emissionTexture, m.metallicRoughnessTexture,
                                                  m.normalTexture, m.opacityTexture},
                                       [&](const TextureUse& use) { return use.exists() && accepts(use); });
        });
    };
    const bool textured = usesTexture([](const TextureUse&) { return true; });
    plan.textured = decide(plan, kept, textured, "textures",
                           textured ? "a triangle's material has a texture" : "no triangle's material has a texture",
                           scene.triangles.size() * 3 * sizeof(glm::vec2) + texelBytes(scene));

    const bool mipmapped = usesTexture([&](const TextureUse& use) { return isMipmapped(scene, use); });
    plan.mipmapped = decide(plan, kept, mipmapped, "mipmaps", reasonOfMipmaps(scene, textured, mipmapped));

    const bool secondUvs = usesTexture([](const TextureUse& use) { return use.uvSet > 0; });
    plan.uvSets = decide(plan, kept, secondUvs, "second uvs",
                         secondUvs ? "a texture is looked up by them" : "no texture is looked up by them",
                         scene.triangles.size() * 3 * sizeof(glm::vec2))
                      ? 2
                      : 1;

    const bool normals = std::any_of(scene.vertices.begin(), scene.vertices.end(),
                                     [](const Vertex& vertex) { return vertex.normal != glm::vec3(0.0f); });
    plan.shadingNormals = decide(plan, kept, normals, "shading normals",
                                 normals ? "a vertex has a normal" : "no vertex has a normal: all triangles are flat");

    const bool mapped = usesMaterial([](const Material& material) { return material.normalTexture.exists(); });
    plan.normalMapped = decide(plan, kept, mapped, "normal maps",
                               mapped ? "a triangle's material has one" : "no triangle's material has one");

    const bool glossy = usesMaterial(isGlossy);
    plan.glossy = decide(plan, kept, glossy, "glossy reflection",
                         glossy ? "a triangle's material is metallic or specular" : "every triangle is Lambertian");

    const bool translucent =
        usesMaterial([](const Material& material) { return material.alphaMode != AlphaMode::Opaque; });
    plan.alphaTested = decide(plan, kept, translucent, "opacity at hits",
                              translucent ? "a triangle's material is not opaque" : "every triangle is opaque");

    const bool culled = usesMaterial([](const Material& material) { return material.culled; });
    plan.culled = decide(plan, kept, culled, "culling of back faces",
                         culled ? "a triangle's material is single-sided" : "every triangle is seen from both sides");

    const bool coloured = std::any_of(scene.vertices.begin(), scene.vertices.end(),
                                      [](const Vertex& vertex) { return vertex.colour != glm::vec4(1.0f); });
    plan.vertexColours =
        decide(plan, kept, coloured, "vertex colours", coloured ? "a vertex has a colour" : "all vertices are white",
               scene.triangles.size() * 3 * sizeof(uint64_t));

    const bool emissionVaries =
        usesMaterial([](const Material& material) { return material.emissionTexture.exists() || material.unlit; });
    plan.emissionTextured = decide(plan, kept, emissionVaries, "emission that varies over a triangle",
                                   emissionVaries ? "a triangle's material has an emission texture, or is unlit"
                                                  : "no triangle's material has an emission texture or is unlit");

    planInstances(plan, scene, kept);

    const bool emissive = usesMaterial(emits);
    const bool hasMap = scene.environment.has_value();
    // Nothing to look up is nothing to look up, as with light paths below.
    plan.environmentMapped = hasMap;
    plan.decisions.push_back(
        {"environment map", !hasMap,
         hasMap ? "the surroundings differ with the direction" : "the surroundings are the same everywhere", 0, false});

    const size_t emitters = countEmitters(scene);
    plan.manyEmitters =
        decide(plan, kept, emitters > 1, "alias table of emitters",
               emitters > 1 ? fmt::format("there are {} to choose from", emitters) : "there is nothing to choose from",
               emitters * sizeof(shared::EmitterChoice));

    const bool environment = hasMap || std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& light) {
                                 return light.type == LightType::Constant;
                             });
    plan.areaLights = emissive || environment;
    plan.decisions.push_back({"samples of area lights", !plan.areaLights,
                              emissive      ? "there are emissive triangles"
                              : environment ? "there is an environment"
                                            : "no emissive triangle and no environment",
                              0, false});

    // Nothing to trace is nothing to trace: --plan off cannot bring light into a scene without any.
    const bool paths = !scene.triangles.empty() && (emissive || hasMap || !scene.lights.empty());
    plan.lightPaths = paths;
    plan.decisions.push_back({"light paths", !paths,
                              scene.triangles.empty() ? "there is no geometry"
                              : paths                 ? "there is light and geometry"
                                                      : "there is no light",
                              0, false});

    plan.pixelVariance = decide(plan, kept, false, kPlanPixelVariance, kNotAskedFor);
    plan.cutOff = decide(plan, kept, false, kPlanCutOff, kNotAskedFor);
    plan.display = decide(plan, kept, false, kPlanDisplay, kNotAskedFor);
    refuseUnknown(plan, keeps);
    return plan;
}

void settle(ScenePlan& plan, const std::string& what, bool isAskedFor) {
    const auto found = std::ranges::find(plan.decisions, what, &PlanDecision::what);
    MANYLIGHT_CHECK(found != plan.decisions.end(), "settle() of {}", what);
    if (found->leftOut == !isAskedFor) return;
    found->leftOut = !isAskedFor;
    found->reason = isAskedFor ? "asked for" : kNotAskedFor;
}

std::string explain(const ScenePlan& plan) {
    std::string text;
    for (const PlanDecision& decision : plan.decisions)
        text += fmt::format("{:8} {:24} {}{}\n", decision.leftOut ? "left out" : "kept", decision.what, decision.reason,
                            decision.savedBytes > 0 ? fmt::format(" ({} bytes saved)", decision.savedBytes) : "");
    return text;
}

Json toJson(const ScenePlan& plan) {
    Json json = Json::array();
    for (const PlanDecision& decision : plan.decisions)
        json.push_back({{"what", decision.what},
                        {"left_out", decision.leftOut},
                        {"reason", decision.reason},
                        {"saved_bytes", decision.savedBytes}});
    return json;
}

}  // namespace manylight
