#include "engine/scene/gltf_check.h"

namespace manylight {
namespace {

void checkTextureInfo(const JsonView& root, const JsonView& owner, std::string_view key) {
    if (!owner.has(key)) return;
    const JsonView info = owner.at(key).expectObject();
    info.at("index");
    checkGltfIndex(root, info, "index", "textures");
    if (info.has("texCoord")) info.at("texCoord").integer(0, 99);
    if (!info.has("extensions") || !info.at("extensions").expectObject().has("KHR_texture_transform")) return;
    const JsonView transform = info.at("extensions").at("KHR_texture_transform").expectObject();
    checkGltfNumbers(transform, "offset", 2);
    checkGltfNumbers(transform, "scale", 2);
    if (transform.has("rotation")) transform.at("rotation").number();
    if (transform.has("texCoord")) transform.at("texCoord").integer(0, 99);
}

void checkNumber(const JsonView& view, std::string_view key) {
    if (view.has(key)) view.at(key).number();
}

void checkAlpha(const JsonView& material, Warnings& warnings) {
    checkNumber(material, "alphaCutoff");
    if (!material.has("alphaMode")) return;
    const std::string mode = material.at("alphaMode").text();
    if (mode != "OPAQUE" && mode != "MASK" && mode != "BLEND")
        warnings.add("alpha modes of unknown kind taken as opaque", material.path());
}

void checkExtensions(const JsonView& material, Warnings& warnings) {
    if (!material.has("extensions")) return;
    const JsonView extensions = material.at("extensions").expectObject();
    if (extensions.has("KHR_materials_emissive_strength")) {
        const JsonView extension = extensions.at("KHR_materials_emissive_strength").expectObject();
        if (extension.has("emissiveStrength") && extension.at("emissiveStrength").number() < 0.0)
            extension.at("emissiveStrength").failExpected("a number that is not negative");
    }
    if (extensions.has("KHR_materials_ior")) {
        const JsonView extension = extensions.at("KHR_materials_ior").expectObject();
        const double ior = extension.has("ior") ? extension.at("ior").number() : 1.5;
        if (ior < 0.0) extension.at("ior").failExpected("a number that is not negative");
        if (ior > 0.0 && ior < 1.0) warnings.add("indices of refraction below one", material.path());
    }
    if (extensions.has("KHR_materials_specular")) {
        const JsonView extension = extensions.at("KHR_materials_specular").expectObject();
        checkNumber(extension, "specularFactor");
        checkGltfNumbers(extension, "specularColorFactor", 3);
    }
}

void checkMaterial(const JsonView& root, const JsonView& material, Warnings& warnings) {
    checkGltfNumbers(material, "emissiveFactor", 3);
    checkTextureInfo(root, material, "emissiveTexture");
    checkTextureInfo(root, material, "normalTexture");
    if (material.has("normalTexture")) checkNumber(material.at("normalTexture"), "scale");
    if (material.has("doubleSided")) material.at("doubleSided").boolean();
    checkAlpha(material, warnings);
    checkExtensions(material, warnings);
    if (!material.has("pbrMetallicRoughness")) return;
    const JsonView pbr = material.at("pbrMetallicRoughness").expectObject();
    checkGltfNumbers(pbr, "baseColorFactor", 4);
    checkNumber(pbr, "metallicFactor");
    checkNumber(pbr, "roughnessFactor");
    checkTextureInfo(root, pbr, "baseColorTexture");
    checkTextureInfo(root, pbr, "metallicRoughnessTexture");
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
