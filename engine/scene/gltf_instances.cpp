#include "engine/scene/gltf_instances.h"

#include "engine/scene/scene_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace manylight {
namespace {

// Of the determinant over the cube of the largest axis: flatter instances are repeated, as inverting them loses digits.
constexpr double kFlattest = 1e-6;

uint64_t trianglesOf(const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
    const auto positions = primitive.attributes.find("POSITION");
    const int accessor = primitive.indices >= 0                    ? primitive.indices
                         : positions != primitive.attributes.end() ? positions->second
                                                                   : -1;
    if (accessor < 0) return 0;
    const uint64_t corners = model.accessors.at(static_cast<size_t>(accessor)).count;
    const bool isList = primitive.mode < 0 || primitive.mode == TINYGLTF_MODE_TRIANGLES;
    return isList ? corners / 3 : corners < 3 ? 0 : corners - 2;
}

bool canBeInstance(const glm::dmat4& m) {
    const glm::dmat3 linear(m);
    const double largest = std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
    const double determinant = std::abs(glm::determinant(linear));
    return std::isfinite(largest) && std::isfinite(glm::length(glm::dvec3(m[3]))) &&
           determinant > kFlattest * largest * largest * largest;
}

bool mirrors(const glm::dmat4& m) { return glm::determinant(glm::dmat3(m)) < 0.0; }

/// Numbers what morph targets make of meshes, so that equal ones can be told; 0: nothing.
class MorphNumbers {
  public:
    size_t of(const GltfMeshUse& use) {
        if (!use.shape.morph || use.shape.morph->empty()) return 0;
        const auto [known, isNew] = byAddress_.try_emplace(use.shape.morph.get(), 0);
        if (isNew) known->second = byValue_.try_emplace(*use.shape.morph, byValue_.size() + 1).first->second;
        return known->second;
    }

  private:
    std::map<const GltfMorph*, size_t> byAddress_;  // nodes share the weights of their mesh
    std::map<GltfMorph, size_t> byValue_;
};

bool mayBeInstance(const GltfMeshUse& use) { return !use.shape.sceneFromBound && canBeInstance(use.sceneFromMesh); }

/// Uses of one mesh that its triangles can serve as they are: those that mirror it need them turned round.
struct Group {
    uint64_t triangles = 0;
    std::vector<const GltfMeshUse*> uses;
    bool moves = false;
};

using Groups = std::map<std::tuple<int, size_t, bool>, Group>;  // by mesh, what morphs it and whether it is mirrored

Groups groupsOf(const GltfFile& gltf, const std::vector<GltfMeshUse>& uses, MorphNumbers& morphs,
                const ImportOptions& options) {
    std::vector<uint64_t> triangles;
    for (const tinygltf::Mesh& mesh : gltf.model.meshes) {
        triangles.push_back(0);
        for (const tinygltf::Primitive& primitive : mesh.primitives)
            triangles.back() += trianglesOf(gltf.model, primitive);
    }
    Groups groups;
    uint64_t shown = 0;
    for (const GltfMeshUse& use : uses) {
        const uint64_t count = triangles[static_cast<size_t>(use.mesh)];
        shown += count;
        checkGltfAmount(gltf, shown, use.place, "triangles");
        if (count == 0 || !mayBeInstance(use)) continue;
        Group& group = groups[{use.mesh, morphs.of(use), mirrors(use.sceneFromMesh)}];
        group.triangles = count;
        group.uses.push_back(&use);
        group.moves = group.moves || (options.keepsMoving && use.moves);
    }
    return groups;
}

/// Reads the mesh in its own coordinates and takes it out of the scene's own triangles.
RawMesh readSharedMesh(const GltfFile& gltf, const GltfMeshUse& use, RawScene& scene) {
    const size_t firstVertex = scene.vertices.size();
    const size_t firstTriangle = scene.triangles.size();
    addGltfMesh(gltf, use.mesh, use.shape, glm::dmat4(1.0), mirrors(use.sceneFromMesh), scene);
    RawMesh shared;
    shared.vertices.assign(scene.vertices.begin() + static_cast<std::ptrdiff_t>(firstVertex), scene.vertices.end());
    shared.triangles.assign(scene.triangles.begin() + static_cast<std::ptrdiff_t>(firstTriangle),
                            scene.triangles.end());
    for (RawTriangle& triangle : shared.triangles)
        for (uint32_t& vertex : triangle.vertex) vertex -= static_cast<uint32_t>(firstVertex);
    scene.vertices.resize(firstVertex);
    scene.triangles.resize(firstTriangle);
    return shared;
}

/// Which groups are shared, and why.
SharingChoice chooseGroups(Groups& groups, const ImportOptions& options) {
    std::vector<RepeatedMesh> repeated;
    for (const auto& [key, group] : groups) repeated.push_back({group.triangles, group.uses.size()});
    SharingChoice choice = chooseSharing(repeated, options.instances);
    std::erase_if(groups, [&](const auto& entry) {
        const Group& group = entry.second;
        const bool saves = isSharedWhere({group.triangles, group.uses.size()}, options.instances);
        return !group.moves && !(choice.shares && saves);
    });
    if (!choice.shares && !groups.empty()) choice = {true, fmt::format("{} meshes move", groups.size()), 0};
    return choice;
}

/// Puts corners of a box round what deforms into RawScene::framePoints.
void frameDeforming(const GltfFile& gltf, const std::vector<GltfMeshUse>& uses, RawScene& scene) {
    glm::dvec3 low(std::numeric_limits<double>::max());
    glm::dvec3 high(std::numeric_limits<double>::lowest());
    for (const GltfMeshUse& use : uses) {
        if (!use.deforms) continue;
        RawScene alone;  // its warnings will be counted with the triangles that are shown
        addGltfMesh(gltf, use.mesh, use.shape, use.sceneFromMesh, false, alone);
        for (const RawTriangle& triangle : alone.triangles)
            for (const uint32_t vertex : triangle.vertex) {
                low = glm::min(low, alone.vertices[vertex].position);
                high = glm::max(high, alone.vertices[vertex].position);
            }
    }
    if (low.x <= high.x) scene.framePoints.insert(scene.framePoints.end(), {low, high});
}

}  // namespace

void addGltfMeshUses(const GltfFile& gltf, const std::vector<GltfMeshUse>& uses, const ImportOptions& options,
                     RawScene& scene) {
    MorphNumbers morphs;
    Groups groups;
    if (options.instances != InstanceMode::Flatten || options.keepsMoving)
        groups = groupsOf(gltf, uses, morphs, options);
    scene.sharing = chooseGroups(groups, options);
    for (const GltfMeshUse& use : uses) {
        if (options.placesOnly) break;
        const bool isMirrored = mirrors(use.sceneFromMesh);
        const bool isShared = mayBeInstance(use) && groups.contains({use.mesh, morphs.of(use), isMirrored});
        if (isShared) continue;
        if (options.keepsMoving && use.moves && !use.shape.sceneFromBound)
            scene.warnings.add("moving meshes not shown where their scale is zero", use.place);
        else
            addGltfMesh(gltf, use.mesh, use.shape, use.sceneFromMesh, isMirrored, scene);
    }
    if (options.placesOnly) frameDeforming(gltf, uses, scene);
    uint32_t number = 0;
    for (const auto& [key, group] : groups) {
        for (const GltfMeshUse* use : group.uses) scene.instances.push_back({number, use->sceneFromMesh});
        if (!options.placesOnly) scene.meshes.push_back(readSharedMesh(gltf, *group.uses.front(), scene));
        ++number;
    }
}

}  // namespace manylight
