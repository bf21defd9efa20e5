#include "engine/scene/obj_materials.h"

#include "engine/core/file.h"
#include "engine/scene/text_lines.h"
#include "engine/scene/texture_file.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <type_traits>

namespace manylight {
namespace {

static_assert(std::is_same_v<tinyobj::real_t, double>, "link tinyobjloader_double");

namespace fs = std::filesystem;

struct Library {
    fs::path path;  // in normal form
    fs::path folder;
    std::map<std::string, int> numbers;
    std::vector<tinyobj::material_t> materials;
};

/// A path as a file written on any system spells it.
fs::path portablePath(std::string_view text) {
    std::string path(trimmed(text));
    if (path.size() > 1 && path.front() == '"' && path.back() == '"') path = path.substr(1, path.size() - 2);
    std::replace(path.begin(), path.end(), '\\', '/');
    return path;
}

/// The three numbers of "Kd r g b", or "Kd grey". Empty for anything else.
std::optional<std::array<double, 3>> parseColour(std::string_view rest) {
    const auto red = parseNumber(takeWord(rest));
    if (!red) return std::nullopt;
    const std::string_view second = takeWord(rest);
    if (second.empty() || second.front() == '#') return std::array{*red, *red, *red};
    const auto green = parseNumber(second);
    const auto blue = parseNumber(takeWord(rest));
    if (!green || !blue) return std::nullopt;
    return std::array{*red, *green, *blue};
}

/// Rewrites what tinyobjloader would misread without a word: "Kd 0.5", "Ke nan 0 0", materials without Kd.
std::string withExplicitColours(std::string_view text, const std::string& file, Warnings& warnings) {
    std::string result;
    result.reserve(text.size() + text.size() / 4);
    TextLines lines(text);
    while (lines.next()) {
        std::string_view rest = lines.line();
        const std::string_view keyword = takeWord(rest);
        if (keyword == "Kd" || keyword == "Ke") {
            const std::string place = fmt::format("{} line {}", file, lines.number());
            auto colour = parseColour(rest);
            if (!colour) warnings.add("material colours set to zero: not three numbers", place);
            if (!colour) colour.emplace(std::array{0.0, 0.0, 0.0});
            for (double& channel : *colour) {
                if (std::isfinite(channel)) continue;
                warnings.add("material colours set to zero: not finite", place);
                channel = 0.0;
            }
            result += fmt::format("{} {} {} {}\n", keyword, (*colour)[0], (*colour)[1], (*colour)[2]);
            continue;
        }
        if (keyword == "newmtl")
            result += fmt::format("newmtl {}\nKd 0.8 0.8 0.8\n", trimmed(rest));
        else
            result.append(trimmed(lines.line())) += '\n';
    }
    return result;
}

void openLibrary(const fs::path& path, std::vector<Library>& libraries, Warnings& warnings) {
    Library library{.path = path.lexically_normal(), .folder = path.parent_path(), .numbers = {}, .materials = {}};
    // Once is enough: a line of names may name one file any number of times.
    if (std::ranges::find(libraries, library.path, &Library::path) != libraries.end()) return;
    std::istringstream text(withExplicitColours(readTextFile(path), path.filename().string(), warnings));
    std::string ignoredWarnings;  // all about dissolve and transmission, which are not read
    tinyobj::LoadMtl(&library.numbers, &library.materials, &text, &ignoredWarnings, nullptr);
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

int32_t loadTexture(const fs::path& folder, const tinyobj::material_t& source, TextureLoader& textures,
                    Warnings& warnings) {
    if (trimmed(source.diffuse_texname).empty()) return kNoTexture;
    const fs::path path = folder / portablePath(source.diffuse_texname);
    const tinyobj::texture_option_t& options = source.diffuse_texopt;
    const bool isMoved = options.origin_offset[0] != 0 || options.origin_offset[1] != 0 || options.scale[0] != 1 ||
                         options.scale[1] != 1;
    if (isMoved) warnings.add("texture offsets and scales ignored", source.name);
    Texture sampling;
    sampling.name = path.lexically_normal().string();
    if (options.clamp) sampling.wrapU = sampling.wrapV = TextureWrap::ClampToEdge;
    return textures.load(sampling, [&] { return readImage8(path); });
}

RawMaterial convert(const Library& library, const tinyobj::material_t& source, TextureLoader& textures,
                    Warnings& warnings) {
    RawMaterial material;
    material.name = source.name;
    material.albedo = {source.diffuse[0], source.diffuse[1], source.diffuse[2]};
    material.emittedRadiance = {source.emission[0], source.emission[1], source.emission[2]};
    material.albedoTexture = loadTexture(library.folder, source, textures, warnings);
    if (!source.emissive_texname.empty()) warnings.add("emissive textures ignored", source.name);
    if (source.dissolve < 1.0 || !source.alpha_texname.empty())
        warnings.add("transparent materials drawn opaque", source.name);
    if (source.specular[0] > 0.0 || source.specular[1] > 0.0 || source.specular[2] > 0.0)
        warnings.add("glossy materials drawn diffuse", source.name);
    return material;
}

}  // namespace

void readObjMaterials(const fs::path& folder, const std::vector<std::string>& libraryLines,
                      const std::vector<std::string>& names, RawScene& scene) {
    std::vector<Library> libraries;
    std::set<std::string> opened;
    for (const std::string& line : libraryLines)
        if (opened.insert(line).second) openLibraries(folder, line, libraries, scene.warnings);

    TextureLoader textures(scene.textures, scene.warnings);
    for (const std::string& name : names) {
        const auto library = std::find_if(libraries.begin(), libraries.end(),
                                          [&](const Library& candidate) { return candidate.numbers.contains(name); });
        if (library != libraries.end()) {
            const auto number = static_cast<size_t>(library->numbers.at(name));
            scene.materials.push_back(convert(*library, library->materials[number], textures, scene.warnings));
            continue;
        }
        scene.materials.push_back({.name = name.empty() ? "default" : name});
        if (!name.empty()) scene.warnings.add("materials not defined: given the default grey", name);
    }
}

}  // namespace manylight
