// Materials and textures as the shaders read them.
#pragma once

#include "engine/scene/scene_plan.h"
#include "shaders/shared/material.h"

#include <cstdint>
#include <vector>

namespace manylight {

struct PackedMaterials {
    std::vector<shared::Material> materials;        // as Scene::materials
    std::vector<shared::TextureInfo> textureInfos;  // one for each use of a texture
    std::vector<uint8_t> texels;                    // RGBA, of all textures that are used
};

/// Takes up what materials emit, where that has changed. False: nowhere.
bool updateEmission(std::vector<shared::Material>& packed, const Scene& scene);

/// Textures that the plan leaves out are kNoTexture, and their texels are not there.
PackedMaterials packMaterials(const Scene& scene, const ScenePlan& plan);

}  // namespace manylight
