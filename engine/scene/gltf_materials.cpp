#include "engine/scene/gltf_materials.h"

#include "engine/core/error.h"
#include "engine/scene/texture_file.h"

#include <cmath>

namespace manylight {
namespace {

TextureWrap wrapOf(int code, const std::string& place, Warnings& warnings) {
    switch (code) {
        case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
            return TextureWrap::ClampToEdge;
        case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
            return TextureWrap::MirroredRepeat;
        case TINYGLTF_TEXTURE_WRAP_REPEAT:
            return TextureWrap::Repeat;
        default:
            warnings.add("texture wraps of unknown kind taken as repeat", place);
            return TextureWrap::Repeat;
    }
}

class MaterialReader {
  public:
    MaterialReader(const GltfFile& gltf, RawScene& scene)
        : gltf_(gltf), scene_(scene), textures_(scene.textures, scene.warnings) {}

    RawMaterial read(const tinygltf::Material& source) {
        const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
        RawMaterial material;
        material.name = source.name;
        material.albedo = {pbr.baseColorFactor[0], pbr.baseColorFactor[1], pbr.baseColorFactor[2]};
        material.emittedRadiance = {source.emissiveFactor[0], source.emissiveFactor[1], source.emissiveFactor[2]};
        material.emittedRadiance *= emissiveStrength(source);
        if (pbr.baseColorTexture.index >= 0) material.surface.albedoTexture.texture = readTexture(pbr.baseColorTexture.index);
        if (pbr.metallicFactor > 0.0 || pbr.roughnessFactor < 1.0)
            scene_.warnings.add("glossy materials drawn diffuse", source.name);
        return material;
    }

  private:
    static double emissiveStrength(const tinygltf::Material& source) {
        const auto found = source.extensions.find("KHR_materials_emissive_strength");
        if (found == source.extensions.end() || !found->second.Has("emissiveStrength")) return 1.0;
        return found->second.Get("emissiveStrength").GetNumberAsDouble();
    }

    int32_t readTexture(int index) {
        const tinygltf::Texture& source = gltf_.model.textures.at(static_cast<size_t>(index));
        const std::string place = fmt::format("textures[{}]", index);
        if (source.source < 0) {
            scene_.warnings.add("textures left out: no image of a known kind", place);
            return kNoTexture;
        }
        Texture sampling;
        sampling.name = fmt::format("images[{}]", source.source);
        if (source.sampler >= 0) {
            const tinygltf::Sampler& sampler = gltf_.model.samplers.at(static_cast<size_t>(source.sampler));
            sampling.wrapU = wrapOf(sampler.wrapS, place, scene_.warnings);
            sampling.wrapV = wrapOf(sampler.wrapT, place, scene_.warnings);
            if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) sampling.filter = TextureFilter::Nearest;
        }
        return textures_.load(sampling, [&] { return decode(static_cast<size_t>(source.source)); });
    }

    EncodedImage decode(size_t index) {
        const Json& image = gltf_.container.json["images"][index];
        const std::string name = fmt::format("{}: images[{}]", gltf_.container.file, index);
        if (image.contains("bufferView")) {
            const auto [bytes, size] = gltfViewBytes(gltf_, image["bufferView"].get<int>());
            return readImage8(bytes, size, name);
        }
        if (!image.contains("uri")) fail("{}: has neither a uri nor a bufferView", name);
        const std::vector<uint8_t> bytes = readGltfUri(gltf_.container, image["uri"].get<std::string>());
        return readImage8(bytes.data(), bytes.size(), name);
    }

    const GltfFile& gltf_;
    RawScene& scene_;
    TextureLoader textures_;
};

glm::dvec2 pairOr(const tinygltf::Value& object, const char* key, glm::dvec2 fallback) {
    if (!object.Has(key)) return fallback;
    return {object.Get(key).Get(0).GetNumberAsDouble(), object.Get(key).Get(1).GetNumberAsDouble()};
}

}  // namespace

GltfTexcoords gltfTexcoords(const tinygltf::Model& model, int material) {
    GltfTexcoords texcoords;
    if (material < 0) return texcoords;
    const tinygltf::TextureInfo& info =
        model.materials.at(static_cast<size_t>(material)).pbrMetallicRoughness.baseColorTexture;
    texcoords.set = info.texCoord;
    const auto found = info.extensions.find("KHR_texture_transform");
    if (found == info.extensions.end()) return texcoords;
    const tinygltf::Value& transform = found->second;
    if (transform.Has("texCoord")) texcoords.set = transform.Get("texCoord").GetNumberAsInt();
    texcoords.offset = pairOr(transform, "offset", glm::dvec2(0.0));
    const glm::dvec2 scale = pairOr(transform, "scale", glm::dvec2(1.0));
    const double angle = transform.Has("rotation") ? transform.Get("rotation").GetNumberAsDouble() : 0.0;
    // Scale first, then rotate counter-clockwise about the origin in a frame whose v grows downwards.
    texcoords.linear = {{std::cos(angle) * scale.x, -std::sin(angle) * scale.x},
                        {std::sin(angle) * scale.y, std::cos(angle) * scale.y}};
    return texcoords;
}

void addGltfMaterials(const GltfFile& gltf, RawScene& scene) {
    MaterialReader reader(gltf, scene);
    for (const tinygltf::Material& source : gltf.model.materials) scene.materials.push_back(reader.read(source));
    scene.materials.push_back({.name = "default", .albedo = glm::dvec3(1.0)});
}

}  // namespace manylight
