#include "engine/scene/mtl.h"

#include "engine/scene/mtl_map.h"
#include "engine/scene/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace manylight {
namespace {

std::string lowerCase(std::string_view word) {
    std::string text(word);
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

class MtlParser {
  public:
    MtlParser(const std::string& file, Warnings& warnings) : file_(file), warnings_(warnings) {}

    std::vector<MtlMaterial> parse(std::string_view text) {
        TextLines lines(text);
        while (lines.next()) {
            std::string_view rest = lines.line();
            const std::string keyword = lowerCase(takeWord(rest));
            if (keyword.empty() || keyword.front() == '#') continue;
            place_ = fmt::format("{} line {}", file_, lines.number());
            if (keyword == "newmtl") {
                materials_.emplace_back().name = trimmed(rest);
                continue;
            }
            if (materials_.empty()) {
                warnings_.add("material statements before any newmtl ignored", place_);
                continue;
            }
            const bool isKnown = readColour(keyword, rest) || readNumber(keyword, rest) || readMap(keyword, rest) ||
                                 isLeftOut(keyword, rest);
            if (!isKnown) warnings_.add("material statements of unknown meaning ignored", place_);
        }
        return std::move(materials_);
    }

  private:
    /// "Kd r g b" or "Kd grey".
    static std::optional<glm::dvec3> threeNumbers(std::string_view rest) {
        const auto red = parseNumber(takeWord(rest));
        if (!red) return std::nullopt;
        const std::string_view second = takeWord(rest);
        if (second.empty() || second.front() == '#') return glm::dvec3(*red);
        const auto green = parseNumber(second);
        const auto blue = parseNumber(takeWord(rest));
        if (!green || !blue) return std::nullopt;
        return glm::dvec3(*red, *green, *blue);
    }

    glm::dvec3 colour(std::string_view rest) {
        const auto numbers = threeNumbers(rest);
        if (!numbers) warnings_.add("material colours set to zero: not three numbers", place_);
        glm::dvec3 colour = numbers.value_or(glm::dvec3(0.0));
        for (int channel = 0; channel < 3; ++channel) {
            if (std::isfinite(colour[channel])) continue;
            warnings_.add("material colours set to zero: not finite", place_);
            colour[channel] = 0.0;
        }
        return colour;
    }

    bool readColour(const std::string& keyword, std::string_view rest) {
        if (keyword == "kd")
            now().diffuse = colour(rest);
        else if (keyword == "ks")
            now().highlight = colour(rest);
        else if (keyword == "ke")
            now().emission = colour(rest);
        else
            return false;
        return true;
    }

    std::optional<double> number(std::string_view rest) {
        const auto value = parseNumber(takeWord(rest));
        if (value && std::isfinite(*value) && *value >= 0.0) return value;
        warnings_.add("material numbers ignored: negative or no finite number", place_);
        return std::nullopt;
    }

    bool readNumber(const std::string& keyword, std::string_view rest) {
        if (keyword == "ns")
            now().exponent = number(rest);
        else if (keyword == "pr")
            now().roughness = number(rest);
        else if (keyword == "pm")
            now().metallic = number(rest);
        else if (keyword == "d")
            readDissolve(rest);
        else if (keyword == "tr")
            readTransparency(rest);
        else if (keyword == "illum")
            readIllumination(rest);
        else
            return false;
        return true;
    }

    void readDissolve(std::string_view rest) {
        std::string_view behind = rest;
        if (takeWord(behind) == "-halo") {
            warnings_.add("opacity that depends on the view taken as constant", place_);
            rest = behind;
        }
        now().opacity = number(rest);
    }

    /// Some programs write "Tr 1" beside "d 1": what d says counts.
    void readTransparency(std::string_view rest) {
        const auto transparency = number(rest);
        if (transparency && !now().opacity) now().opacity = 1.0 - std::min(*transparency, 1.0);
    }

    void readIllumination(std::string_view rest) {
        const auto model = number(rest);
        if (model && *model <= 10.0) now().illumination = static_cast<int>(*model);
    }

    bool readMap(const std::string& keyword, std::string_view rest) {
        std::optional<MtlMap>* const map = keyword == "map_kd"                          ? &now().diffuseMap
                                           : keyword == "map_ke"                        ? &now().emissionMap
                                           : keyword == "map_d"                         ? &now().opacityMap
                                           : keyword == "norm" || keyword == "map_norm" ? &now().normalMap
                                           : keyword == "bump" || keyword == "map_bump" ? &now().bumpMap
                                                                                        : nullptr;
        if (map) *map = parseMtlMap(rest, place_, warnings_);
        return map != nullptr;
    }

    /// Statements with a meaning that the engine has no use for.
    bool isLeftOut(const std::string& keyword, std::string_view rest) {
        if (isOneOf(keyword, {"map_ks", "map_ns", "map_pr", "map_pm", "map_ps", "map_tr", "refl", "disp", "decal"})) {
            warnings_.add("textures left out: only map_Kd, map_Ke, map_d, norm and bump are read", place_);
            return true;
        }
        if (isOneOf(keyword, {"ps", "pc", "pcr", "aniso", "anisor"})) {
            if (parseNumber(takeWord(rest)).value_or(0.0) != 0.0)
                warnings_.add("sheen, clearcoat and anisotropy left out", place_);
            return true;
        }
        // No part of light transport, or of refraction, which is counted with the illumination model.
        return isOneOf(keyword, {"ka", "map_ka", "ni", "tf", "sharpness", "map_aat"});
    }

    MtlMaterial& now() { return materials_.back(); }

    const std::string& file_;
    Warnings& warnings_;
    std::string place_;
    std::vector<MtlMaterial> materials_;
};

}  // namespace

std::vector<MtlMaterial> parseMtl(std::string_view text, const std::string& file, Warnings& warnings) {
    return MtlParser(file, warnings).parse(text);
}

}  // namespace manylight
