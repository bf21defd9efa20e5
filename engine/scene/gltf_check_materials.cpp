#include "engine/scene/gltf_check.h"

namespace manylight {
namespace {

void checkTextureInfo(const JsonView& root, const JsonView& owner, std::string_view key) {
    if (!owner.has(key)) return;
    const JsonView info = owner.at(key).expectObject();
    info.at("index");
    checkGltfIndex(root, info, "index", "textures");
    if (info.has("texCoord")) info.at("texCoord").integer(0, 99);
    if (!info.has("extensions") || !info.at("extensions").has("KHR_texture_transform")) return;
    const JsonView transform = info.at("extensions").at("KHR_texture_transform").expectObject();
    checkGltfNumbers(transform, "offset", 2);
    checkGltfNumbers(transform, "scale", 2);
    if (transform.has("rotation")) transform.at("rotation").number();
    if (transform.has("texCoord")) transform.at("texCoord").integer(0, 99);
}

void checkMaterial(const JsonView& root, const JsonView& material, Warnings& warnings) {
    checkGltfNumbers(material, "emissiveFactor", 3);
    checkTextureInfo(root, material, "emissiveTexture");
    if (material.has("emissiveTexture")) warnings.add("emissive textures ignored", material.path());
    if (material.has("alphaMode") && material.at("alphaMode").text() != "OPAQUE")
        warnings.add("transparent materials drawn opaque", material.path());
    if (material.has("extensions") && material.at("extensions").has("KHR_materials_emissive_strength")) {
        const JsonView extension = material.at("extensions").at("KHR_materials_emissive_strength").expectObject();
        if (extension.has("emissiveStrength") && extension.at("emissiveStrength").number() < 0.0)
            extension.at("emissiveStrength").failExpected("a number that is not negative");
    }
    if (!material.has("pbrMetallicRoughness")) return;
    const JsonView pbr = material.at("pbrMetallicRoughness").expectObject();
    checkGltfNumbers(pbr, "baseColorFactor", 4);
    checkTextureInfo(root, pbr, "baseColorTexture");
}

void checkImage(const JsonView& root, const JsonView& image) {
    checkGltfIndex(root, image, "bufferView", "bufferViews");
    if (image.has("uri")) image.at("uri").text();
}

}  // namespace

void checkGltfMaterials(const JsonView& root, Warnings& warnings) {
    forEachGltf(root, "images", [&](const JsonView& image) { checkImage(root, image); });
    forEachGltf(root, "samplers", [&](const JsonView& sampler) {
        for (const std::string_view key : {"magFilter", "minFilter", "wrapS", "wrapT"})
            if (sampler.has(key)) sampler.at(key).integer(0, INT32_MAX);
    });
    forEachGltf(root, "textures", [&](const JsonView& texture) {
        checkGltfIndex(root, texture, "sampler", "samplers");
        checkGltfIndex(root, texture, "source", "images");
    });
    forEachGltf(root, "materials", [&](const JsonView& material) { checkMaterial(root, material, warnings); });
}

}  // namespace manylight
