#include "engine/core/check.h"
#include "engine/scene/emission_scale.h"
#include "engine/scene/normalise_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace manylight {
namespace {

constexpr double kLargestFloat = double{std::numeric_limits<float>::max()};

glm::vec3 repairedAlbedo(const RawMaterial& material, Warnings& warnings) {
    glm::vec3 repaired(0.0f);
    bool isBad = false;
    for (int channel = 0; channel < 3; ++channel) {
        const double value = material.albedo[channel];
        repaired[channel] = std::isnan(value) ? 0.0f : static_cast<float>(std::clamp(value, 0.0, 1.0));
        isBad = isBad || !(value >= 0.0 && value <= 1.0);
    }
    if (isBad) warnings.add("albedos clamped to [0, 1]", material.name);
    return repaired;
}

/// Brings a number into [0, 1]; what is none becomes `fallback`.
float repairedShare(float value, float fallback, const char* what, const std::string& name, Warnings& warnings) {
    if (value >= 0.0f && value <= 1.0f) return value;
    warnings.add("material values brought into [0, 1]", fmt::format("{}: {}", name, what));
    return std::isnan(value) ? fallback : std::clamp(value, 0.0f, 1.0f);
}

void repairUse(TextureUse& use, const Scene& scene, const std::string& name, Warnings& warnings) {
    MANYLIGHT_CHECK(use.texture < static_cast<int32_t>(scene.textures.size()), "{}", name);
    MANYLIGHT_CHECK(use.uvSet < 2u, "{}", name);
    bool isFinite = true;
    for (const glm::vec2& v : {use.uvMatrix[0], use.uvMatrix[1], use.uvOffset})
        isFinite = isFinite && std::isfinite(v.x) && std::isfinite(v.y);
    if (isFinite) return;
    warnings.add("texture transforms removed: not finite", name);
    use.uvMatrix = glm::mat2(1.0f);
    use.uvOffset = glm::vec2(0.0f);
}

void repairSurface(Material& m, const Scene& scene, Warnings& warnings) {
    const Material fallback;
    const auto repair = [&](float& value, float instead, const char* what) {
        value = repairedShare(value, instead, what, m.name, warnings);
    };
    repair(m.metallic, fallback.metallic, "metallic");
    repair(m.roughness, fallback.roughness, "roughness");
    repair(m.opacity, fallback.opacity, "opacity");
    repair(m.alphaCutoff, fallback.alphaCutoff, "alpha cutoff");
    for (int channel = 0; channel < 3; ++channel) repair(m.specular[channel], 0.0f, "specular");
    for (TextureUse* const use :
         {&m.albedoTexture, &m.emissionTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.opacityTexture})
        repairUse(*use, scene, m.name, warnings);
    if (std::isfinite(m.normalScale)) return;
    warnings.add("scales of normal maps set to one: not finite", m.name);
    m.normalScale = fallback.normalScale;
}

}  // namespace

glm::vec3 repairedEmission(const glm::dvec3& emission, const std::string& name, Warnings& warnings) {
    glm::vec3 repaired(0.0f);
    bool isBad = false;
    for (int channel = 0; channel < 3; ++channel) {
        const double value = emission[channel];
        if (value >= 0.0 && value <= kLargestFloat)
            repaired[channel] = static_cast<float>(value);
        else
            isBad = true;
    }
    if (isBad) warnings.add("emission channels set to zero: negative, not finite or too large", name);
    return repaired;
}

void convertMaterials(const RawScene& raw, Scene& scene) {
    scene.materials.reserve(raw.materials.size());
    for (const RawMaterial& source : raw.materials) {
        Material material = source.surface;
        material.name = source.name;
        material.albedo = repairedAlbedo(source, scene.warnings);
        material.givenRadiance = repairedEmission(source.emittedRadiance, source.name, scene.warnings);
        scaleEmission(material, source.emissionScale);
        repairSurface(material, scene, scene.warnings);
        scene.materials.push_back(std::move(material));
    }
}

}  // namespace manylight
