#include "engine/scene/gltf_materials.h"

#include <fmt/format.h>

#include <algorithm>

namespace manylight {
namespace {

const Json& partOf(const Json& object, const char* key) {
    static const Json kEmpty = Json::object();
    const auto found = object.find(key);
    return found == object.end() ? kEmpty : *found;
}

const Json& extensionOf(const Json& material, const char* name) { return partOf(partOf(material, "extensions"), name); }

bool isUnlit(const Json& material) { return partOf(material, "extensions").contains("KHR_materials_unlit"); }

/// Three or four numbers, checked before.
template <typename Vector>
Vector numbersOr(const Json& object, const char* key, Vector fallback) {
    if (object.contains(key))
        for (int i = 0; i < Vector::length(); ++i) fallback[i] = object[key][static_cast<size_t>(i)].get<double>();
    return fallback;
}

/// Reflectance at normal incidence of what is not metal.
glm::dvec3 specularOf(const Json& material, const std::string& place, Warnings& warnings) {
    const double ior = extensionOf(material, "KHR_materials_ior").value("ior", 1.5);
    // The extension gives zero the meaning of infinity.
    const double root = ior == 0.0 ? 1.0 : (ior - 1.0) / (ior + 1.0);
    const Json& extension = extensionOf(material, "KHR_materials_specular");
    if (extension.contains("specularTexture") || extension.contains("specularColorTexture"))
        warnings.add("textures of KHR_materials_specular left out", place);
    const glm::dvec3 tint = numbersOr(extension, "specularColorFactor", glm::dvec3(1.0));
    return glm::min(root * root * tint, 1.0) * extension.value("specularFactor", 1.0);
}

class MaterialReader {
  public:
    MaterialReader(const GltfFile& gltf, RawScene& scene)
        : gltf_(gltf), warnings_(scene.warnings), textures_(gltf, scene) {}

    RawMaterial read(const Json& source, size_t index) {
        place_ = fmt::format("materials[{}]", index);
        sets_ = gltfUvSets(gltf_, static_cast<int>(index));
        RawMaterial material;
        if (source.contains("name") && source["name"].is_string()) material.name = source["name"].get<std::string>();
        material.surface.culled = !source.value("doubleSided", false);
        readBaseColour(source, material);
        if (isUnlit(source)) {
            material.surface.unlit = true;
            return material;
        }
        readReflection(source, material.surface);
        readEmission(source, material);
        return material;
    }

  private:
    TextureUse texture(const Json& owner, const char* key) { return textures_.read(owner, key, sets_, place_); }

    void readBaseColour(const Json& source, RawMaterial& material) {
        const Json& pbr = partOf(source, "pbrMetallicRoughness");
        const glm::dvec4 factor = numbersOr(pbr, "baseColorFactor", glm::dvec4(1.0));
        Material& surface = material.surface;
        material.albedo = glm::dvec3(factor);
        surface.albedoTexture = texture(pbr, "baseColorTexture");
        const std::string mode = source.value("alphaMode", std::string("OPAQUE"));
        if (mode != "MASK" && mode != "BLEND") return;
        surface.alphaMode = mode == "MASK" ? AlphaMode::Mask : AlphaMode::Blend;
        surface.opacity = static_cast<float>(factor.a);
        surface.opacityTexture = surface.albedoTexture;
        const double cutoff = source.value("alphaCutoff", 0.5);
        surface.alphaCutoff = static_cast<float>(std::min(cutoff, 1.0));
        // A cutoff that nothing reaches hides all of the surface.
        if (surface.alphaMode == AlphaMode::Mask && cutoff > 1.0) surface.opacity = 0.0f;
    }

    void readReflection(const Json& source, Material& surface) {
        const Json& pbr = partOf(source, "pbrMetallicRoughness");
        surface.metallic = static_cast<float>(pbr.value("metallicFactor", 1.0));
        surface.roughness = static_cast<float>(pbr.value("roughnessFactor", 1.0));
        surface.metallicRoughnessTexture = texture(pbr, "metallicRoughnessTexture");
        surface.specular = glm::vec3(specularOf(source, place_, warnings_));
        surface.normalTexture = texture(source, "normalTexture");
        surface.normalScale = static_cast<float>(partOf(source, "normalTexture").value("scale", 1.0));
    }

    void readEmission(const Json& source, RawMaterial& material) {
        const Json& extension = extensionOf(source, "KHR_materials_emissive_strength");
        material.emittedRadiance =
            numbersOr(source, "emissiveFactor", glm::dvec3(0.0)) * extension.value("emissiveStrength", 1.0);
        if (material.emittedRadiance != glm::dvec3(0.0))
            material.surface.emissionTexture = texture(source, "emissiveTexture");
    }

    const GltfFile& gltf_;
    Warnings& warnings_;
    GltfTextures textures_;
    std::string place_;
    GltfUvSets sets_{};
};

}  // namespace

GltfUvSets gltfUvSets(const GltfFile& gltf, int material) {
    constexpr int kFree = -1;
    if (material < 0) return {0, 1};
    const Json& source = gltf.container.json["materials"][static_cast<size_t>(material)];
    const Json& pbr = partOf(source, "pbrMetallicRoughness");
    std::vector<int> used;
    const auto note = [&](const Json& owner, const char* key) {
        if (!owner.contains(key)) return;
        const int set = gltfUvSet(owner[key]);
        if (std::find(used.begin(), used.end(), set) == used.end()) used.push_back(set);
    };
    note(pbr, "baseColorTexture");
    note(source, "emissiveTexture");
    note(pbr, "metallicRoughnessTexture");
    note(source, "normalTexture");
    if (used.size() > 2) used.resize(2);

    // Sets 0 and 1 keep their places; others take what is free.
    GltfUvSets sets = {kFree, kFree};
    for (const int set : used)
        if (set < 2) sets[static_cast<size_t>(set)] = set;
    for (const int set : used)
        if (set >= 2) *std::find(sets.begin(), sets.end(), kFree) = set;
    for (int slot = 0; slot < 2; ++slot)
        if (sets[static_cast<size_t>(slot)] == kFree) sets[static_cast<size_t>(slot)] = slot;
    return sets;
}

void addGltfMaterials(const GltfFile& gltf, RawScene& scene) {
    MaterialReader reader(gltf, scene);
    const Json& materials = partOf(gltf.container.json, "materials");
    for (size_t i = 0; i < materials.size(); ++i) scene.materials.push_back(reader.read(materials[i], i));
    // The default is a material with every key left out.
    RawMaterial byDefault = {.name = "default", .albedo = glm::dvec3(1.0)};
    byDefault.surface.metallic = 1.0f;
    byDefault.surface.specular = glm::vec3(0.04f);
    scene.materials.push_back(byDefault);
}

}  // namespace manylight
