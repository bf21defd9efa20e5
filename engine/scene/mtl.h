// The statements of an MTL file, as they are written: what they mean is obj_materials.h's.
#pragma once

#include "engine/core/report.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace manylight {

/// A texture with its options: looked up at scale * uv + offset, v growing upwards.
struct MtlMap {
    std::string file;  // as written
    glm::dvec2 offset{0.0};
    glm::dvec2 scale{1.0};
    bool isClamped = false;
    double bumpMultiplier = 1.0;
    char channel = 'l';  // -imfchan: r, g, b, m (alpha), l (luminance)
};

/// Empty where the file says nothing. All numbers are finite.
struct MtlMaterial {
    std::string name;
    std::optional<glm::dvec3> diffuse;    // Kd
    std::optional<glm::dvec3> highlight;  // Ks
    std::optional<glm::dvec3> emission;   // Ke
    std::optional<double> exponent;       // Ns, not negative
    std::optional<double> opacity;        // d, or 1 - Tr
    std::optional<double> roughness;      // Pr
    std::optional<double> metallic;       // Pm
    std::optional<int> illumination;      // illum
    std::optional<MtlMap> diffuseMap;     // map_Kd
    std::optional<MtlMap> emissionMap;    // map_Ke
    std::optional<MtlMap> opacityMap;     // map_d
    std::optional<MtlMap> normalMap;      // norm
    std::optional<MtlMap> bumpMap;        // bump, map_bump
};

/// Parses MTL text by tinyobjloader; keywords in any case. What cannot be used is counted with file and line.
std::vector<MtlMaterial> parseMtl(std::string_view text, const std::string& file, Warnings& warnings);

}  // namespace manylight
