#include "engine/scene/mtl.h"

#include "engine/scene/mtl_explicit.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <sstream>
#include <type_traits>

namespace manylight {
namespace {

static_assert(std::is_same_v<tinyobj::real_t, double>, "link tinyobjloader_double");

bool isStated(const tinyobj::material_t& source, std::string_view keyword) {
    return source.unknown_parameter.contains(fmt::format("{}{}", kStatedPrefix, keyword));
}

bool isChannel(char letter) { return std::string_view("rgbml").find(letter) != std::string_view::npos; }

std::optional<glm::dvec3> colourIf(bool isStated, const double (&values)[3]) {
    if (!isStated) return std::nullopt;
    return glm::dvec3(values[0], values[1], values[2]);
}

template <typename T>
std::optional<T> valueIf(bool isStated, T value) {
    return isStated ? std::optional<T>(value) : std::nullopt;
}

/// Counts the options that the engine has no use for.
void checkOptions(const tinyobj::texture_option_t& options, const std::string& place, Warnings& warnings) {
    const auto count = [&](bool isThere, std::string_view name) {
        if (isThere) warnings.add("texture options ignored", fmt::format("{}: {}", place, name));
    };
    const auto& turbulence = options.turbulence;
    count(turbulence[0] != 0.0 || turbulence[1] != 0.0 || turbulence[2] != 0.0, "-t");
    count(options.brightness != 0.0 || options.contrast != 1.0, "-mm");
    count(options.type != tinyobj::TEXTURE_TYPE_NONE, "-type");
    count(!isChannel(options.imfchan), "-imfchan");
}

std::optional<MtlMap> mapOf(const std::string& file, const tinyobj::texture_option_t& options, const std::string& place,
                            Warnings& warnings) {
    if (file.empty()) return std::nullopt;
    checkOptions(options, place, warnings);
    return MtlMap{.file = file,
                  .offset = {options.origin_offset[0], options.origin_offset[1]},
                  .scale = {options.scale[0], options.scale[1]},
                  .isClamped = options.clamp,
                  .bumpMultiplier = options.bump_multiplier,
                  .channel = isChannel(options.imfchan) ? options.imfchan : 'l'};
}

MtlMaterial materialOf(const tinyobj::material_t& source, const std::string& file, Warnings& warnings) {
    const std::string place = fmt::format("{}: {}", file, source.name);
    const auto stated = [&](std::string_view keyword) { return isStated(source, keyword); };
    const auto map = [&](const std::string& name, const tinyobj::texture_option_t& options) {
        return mapOf(name, options, place, warnings);
    };
    if (source.sheen != 0.0 || source.clearcoat_thickness != 0.0 || source.anisotropy != 0.0)
        warnings.add("sheen, clearcoat and anisotropy left out", place);
    return {.name = source.name,
            .diffuse = colourIf(stated("Kd"), source.diffuse),
            .highlight = colourIf(stated("Ks"), source.specular),
            .emission = colourIf(stated("Ke"), source.emission),
            .exponent = valueIf(stated("Ns"), source.shininess),
            .opacity = valueIf(stated("d") || stated("Tr"), source.dissolve),
            .roughness = valueIf(stated("Pr"), source.roughness),
            .metallic = valueIf(stated("Pm"), source.metallic),
            .illumination = valueIf(stated("illum"), source.illum),
            .diffuseMap = map(source.diffuse_texname, source.diffuse_texopt),
            .emissionMap = map(source.emissive_texname, source.emissive_texopt),
            .opacityMap = map(source.alpha_texname, source.alpha_texopt),
            .normalMap = map(source.normal_texname, source.normal_texopt),
            .bumpMap = map(source.bump_texname, source.bump_texopt)};
}

}  // namespace

std::vector<MtlMaterial> parseMtl(std::string_view text, const std::string& file, Warnings& warnings) {
    std::istringstream explicitText(explicitMtl(text, file, warnings));
    std::map<std::string, int> numbers;
    std::vector<tinyobj::material_t> sources;
    std::string ignoredWarnings;  // that d comes before Tr
    tinyobj::LoadMtl(&numbers, &sources, &explicitText, &ignoredWarnings, nullptr);

    std::vector<MtlMaterial> materials;
    for (const tinyobj::material_t& source : sources)
        if (!source.name.empty()) materials.push_back(materialOf(source, file, warnings));  // one has none in no text
    return materials;
}

}  // namespace manylight
