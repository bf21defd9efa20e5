#include "engine/scene/obj_materials.h"

#include "engine/core/file.h"
#include "engine/scene/mtl.h"
#include "engine/scene/obj_textures.h"
#include "engine/scene/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace manylight {
namespace {

namespace fs = std::filesystem;

struct Library {
    fs::path path;  // in normal form
    fs::path folder;
    std::map<std::string, MtlMaterial> materials;
};

void openLibrary(const fs::path& path, std::vector<Library>& libraries, Warnings& warnings) {
    Library library{.path = path.lexically_normal(), .folder = path.parent_path(), .materials = {}};
    // Once is enough: a line of names may name one file any number of times.
    if (std::ranges::find(libraries, library.path, &Library::path) != libraries.end()) return;
    const std::string file = path.filename().string();
    for (MtlMaterial& material : parseMtl(readTextFile(path), file, warnings)) {
        const std::string name = material.name;
        if (!library.materials.emplace(name, std::move(material)).second)
            warnings.add("materials defined twice: the first is used", fmt::format("{}: {}", file, name));
    }
    libraries.push_back(std::move(library));
}

/// Takes a file name off `rest`; a backslash before a blank makes it part of the name.
std::string takeFileName(std::string_view& rest) {
    std::string name(takeWord(rest));
    while (name.ends_with('\\') && !trimmed(rest).empty()) {
        name.back() = ' ';
        name += takeWord(rest);
    }
    return name;
}

/// An mtllib line may name one file with blanks in its name or several files.
void openLibraries(const fs::path& folder, const std::string& line, std::vector<Library>& libraries,
                   Warnings& warnings) {
    if (const fs::path whole = folder / portablePath(line); isRegularFile(whole))
        return openLibrary(whole, libraries, warnings);
    std::string_view rest = line;
    for (std::string name = takeFileName(rest); !name.empty(); name = takeFileName(rest)) {
        const fs::path path = folder / portablePath(name);
        if (isRegularFile(path))
            openLibrary(path, libraries, warnings);
        else
            warnings.add("material libraries missing", name);
    }
}

/// Perceptual roughness of Phong's exponent: Beckmann's alpha of equal width (Walter2007), taken as GGX's.
double roughnessOf(double exponent) { return std::sqrt(std::sqrt(2.0 / (exponent + 2.0))); }

bool asksForReflection(const MtlMaterial& source) { return source.illumination && *source.illumination >= 3; }

/// A black material with a strong highlight, or with one and a model that reflects: Phong's way to write a metal.
bool isMetal(const MtlMaterial& source, const RawMaterial& material, double strongest) {
    const bool isBlack = material.albedo == glm::dvec3(0.0);
    return isBlack && (strongest > 0.5 || (strongest > 0.0 && asksForReflection(source)));
}

void convertReflection(const MtlMaterial& source, RawMaterial& material, Warnings& warnings) {
    constexpr double kSpecularOfFullHighlight = 0.08;  // so that 0.5, which modelling tools write, is glass's 0.04
    Material& surface = material.surface;
    const bool isPbr = source.roughness || source.metallic;
    const bool hasHighlight = isPbr || !source.illumination || *source.illumination >= 2;
    const glm::dvec3 written = source.highlight.value_or(glm::dvec3(isPbr ? 0.5 : 0.0));
    const glm::dvec3 highlight = hasHighlight ? glm::clamp(written, 0.0, 1.0) : glm::dvec3(0.0);
    const double strongest = std::max({highlight.r, highlight.g, highlight.b});
    if (hasHighlight && highlight != written) warnings.add("highlights clamped to [0, 1]", source.name);
    if (strongest == 0.0 && !isPbr) return;

    surface.roughness = static_cast<float>(source.roughness.value_or(roughnessOf(source.exponent.value_or(0.0))));
    if (!isPbr && isMetal(source, material, strongest)) {
        surface.metallic = 1.0f;
        surface.albedoTexture = {};  // black times a texture was black
        material.albedo = highlight;
        return;
    }
    surface.metallic = static_cast<float>(source.metallic.value_or(0.0));
    surface.specular = glm::vec3(kSpecularOfFullHighlight * highlight);
}

void convertOpacity(const fs::path& folder, const MtlMaterial& source, ObjTextures& textures, Material& surface) {
    surface.opacity = static_cast<float>(source.opacity.value_or(1.0));
    ObjTextures::Coverage coverage;
    if (source.opacityMap) coverage = textures.coverage(folder, *source.opacityMap);
    surface.opacityTexture = coverage.use;
    if (!coverage.use.exists() && surface.opacity == 1.0f) return;
    const bool isMask = coverage.use.exists() && coverage.isCutout && surface.opacity == 1.0f;
    surface.alphaMode = isMask ? AlphaMode::Mask : AlphaMode::Blend;
}

void convertNormals(const fs::path& folder, const MtlMaterial& source, ObjTextures& textures, Material& surface) {
    if (source.normalMap) {
        surface.normalTexture = textures.colour(folder, *source.normalMap);
        surface.normalScale = static_cast<float>(source.normalMap->bumpMultiplier);
    } else if (source.bumpMap && source.bumpMap->bumpMultiplier != 0.0) {
        const ObjTextures::Normals normals = textures.bump(folder, *source.bumpMap);
        surface.normalTexture = normals.use;
        surface.normalScale = static_cast<float>(normals.scale);
    }
}

RawMaterial convert(const fs::path& folder, const MtlMaterial& source, ObjTextures& textures, Warnings& warnings) {
    RawMaterial material;
    material.name = source.name;
    material.albedo = source.diffuse.value_or(glm::dvec3(0.8));
    // A map alone is as bright as it is drawn.
    material.emittedRadiance = source.emission.value_or(glm::dvec3(source.emissionMap ? 1.0 : 0.0));
    Material& surface = material.surface;
    if (source.diffuseMap) surface.albedoTexture = textures.colour(folder, *source.diffuseMap);
    if (source.emissionMap && material.emittedRadiance != glm::dvec3(0.0))
        surface.emissionTexture = textures.colour(folder, *source.emissionMap);
    convertReflection(source, material, warnings);
    convertOpacity(folder, source, textures, surface);
    convertNormals(folder, source, textures, surface);
    const int model = source.illumination.value_or(0);
    if (model == 4 || model == 6 || model == 7 || model == 9) warnings.add("refraction left out", source.name);
    return material;
}

}  // namespace

void readObjMaterials(const fs::path& folder, const std::vector<std::string>& libraryLines,
                      const std::vector<std::string>& names, RawScene& scene) {
    std::vector<Library> libraries;
    std::set<std::string> opened;
    for (const std::string& line : libraryLines)
        if (opened.insert(line).second) openLibraries(folder, line, libraries, scene.warnings);

    ObjTextures textures(scene);
    for (const std::string& name : names) {
        const auto library = std::find_if(libraries.begin(), libraries.end(),
                                          [&](const Library& candidate) { return candidate.materials.contains(name); });
        if (library != libraries.end()) {
            scene.materials.push_back(convert(library->folder, library->materials.at(name), textures, scene.warnings));
            continue;
        }
        scene.materials.push_back({.name = name.empty() ? "default" : name});
        if (!name.empty()) scene.warnings.add("materials not defined: given the default grey", name);
    }
}

}  // namespace manylight
