// The showcase's materials, and the textures that they name.
#include "engine/scene/generate/generated_scene.h"
#include "engine/scene/generate/showcase_parts.h"

#include <array>

namespace manylight::showcase {
namespace {

/// How a material looks a picture up.
struct Lookup {
    PictureNumber picture = kNoPicture;
    int uvSet = 0;
    double perMetre = 1.0;  // or how often it is repeated over a patch
};

struct Look {
    const char* name;
    glm::dvec3 colour{1.0};
    double opacity = 1.0;
    double metallic = 0.0;
    double roughness = 1.0;
    Lookup base{};
    Lookup metallicRoughness{};
    Lookup normal{};
    glm::dvec3 emission{0.0};  // its largest component is the strength
    Lookup emissionPicture{};
    const char* alphaMode = "OPAQUE";
    bool isDoubleSided = true;
    bool isUnlit = false;
};

// In the order of MaterialNumber.
const std::array<Look, kScreen + 1> kLooks{{
    {.name = "floor",
     .base = {kFloorColour, 0, 0.8},
     .metallicRoughness = {kFloorRoughness, 0, 0.8},
     .normal = {kFloorNormal, 0, 0.8},
     .isDoubleSided = false},
    {.name = "wall", .roughness = 0.95, .base = {kWallpaper, 0, 2.5}, .isDoubleSided = false},
    {.name = "ceiling", .colour = glm::dvec3(0.78), .roughness = 0.95, .isDoubleSided = false},
    {.name = "paint", .colour = {0.76, 0.74, 0.69}, .roughness = 0.4},
    {.name = "wood", .roughness = 0.45, .base = {kGrain, 0, 1.4}},
    {.name = "fabric",
     .colour = {0.1, 0.27, 0.28},
     .roughness = 0.95,
     .base = {kWeaveColour, 0, 14.0},
     .normal = {kWeaveNormal, 0, 14.0}},
    {.name = "cushion", .roughness = 0.95, .base = {kEmbroidery, 1}, .normal = {kWeaveNormal, 0, 18.0}},
    {.name = "rug", .roughness = 1.0, .base = {kRugPattern, 1}, .normal = {kWeaveNormal, 0, 20.0}},
    {.name = "brass", .colour = {0.83, 0.62, 0.3}, .metallic = 1.0, .metallicRoughness = {kBrushed, 0, 3.0}},
    {.name = "glaze", .colour = {0.12, 0.22, 0.42}, .roughness = 0.25},
    {.name = "orange", .colour = {0.75, 0.28, 0.04}, .roughness = 0.5},
    {.name = "leaf", .roughness = 0.55, .base = {kLeafShape, 1}, .alphaMode = "MASK"},
    {.name = "curtain", .roughness = 1.0, .base = {kGauze, 0, 2.0}, .alphaMode = "BLEND"},
    {.name = "glass", .colour = {0.3, 0.42, 0.38}, .opacity = 0.35, .roughness = 0.2, .alphaMode = "BLEND"},
    {.name = "book", .roughness = 0.7},
    {.name = "lantern", .colour = {0.5, 0.46, 0.38}, .emission = {3.2, 2.35, 1.45}, .emissionPicture = {kPaperRibs, 1}},
    {.name = "shade", .colour = {0.6, 0.52, 0.4}, .emission = {3.6, 2.4, 1.25}, .emissionPicture = {kPaperRibs, 1}},
    {.name = "bulb", .colour = glm::dvec3(0.2), .emission = {24.0, 19.0, 12.0}},
    {.name = "painting", .roughness = 0.8, .base = {kCanvas, 1}},
    {.name = "screen", .base = {kSunset, 1}, .isUnlit = true},
}};

Json textureInfo(const Lookup& lookup) {
    Json info{{"index", lookup.picture}, {"texCoord", lookup.uvSet}};
    if (lookup.perMetre != 1.0)
        info["extensions"]["KHR_texture_transform"] = {{"scale", {lookup.perMetre, lookup.perMetre}}};
    return info;
}

void addTexture(Json& owner, const char* key, const Lookup& lookup) {
    if (lookup.picture != kNoPicture) owner[key] = textureInfo(lookup);
}

Json materialOf(const Look& look) {
    Json pbr{{"baseColorFactor", {look.colour.r, look.colour.g, look.colour.b, look.opacity}},
             {"metallicFactor", look.metallic},
             {"roughnessFactor", look.roughness}};
    addTexture(pbr, "baseColorTexture", look.base);
    addTexture(pbr, "metallicRoughnessTexture", look.metallicRoughness);
    Json material{{"name", look.name},
                  {"doubleSided", look.isDoubleSided},
                  {"alphaMode", look.alphaMode},
                  {"pbrMetallicRoughness", pbr}};
    addTexture(material, "normalTexture", look.normal);
    addTexture(material, "emissiveTexture", look.emissionPicture);
    if (look.emission.r > 0.0) {
        material["emissiveFactor"] = toJson(look.emission / look.emission.r);
        material["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", look.emission.r}};
    }
    if (look.isUnlit) material["extensions"]["KHR_materials_unlit"] = Json::object();
    return material;
}

}  // namespace

void addMaterials(GltfText& gltf, const std::vector<Picture>& pictures) {
    constexpr int kLinear = 9729;
    constexpr int kLinearMipmapLinear = 9987;
    constexpr int kRepeat = 10497;
    constexpr int kClampToEdge = 33071;
    for (const int wrap : {kRepeat, kClampToEdge})
        gltf.json["samplers"].push_back(
            {{"magFilter", kLinear}, {"minFilter", kLinearMipmapLinear}, {"wrapS", wrap}, {"wrapT", wrap}});
    for (const Picture& picture : pictures) {
        gltf.json["textures"].push_back({{"source", gltf.json["images"].size()}, {"sampler", picture.isTiled ? 0 : 1}});
        gltf.json["images"].push_back({{"uri", picture.name + ".png"}});
    }
    for (const Look& look : kLooks) gltf.json["materials"].push_back(materialOf(look));
}

}  // namespace manylight::showcase
