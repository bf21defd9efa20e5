#include "engine/scene/mtl_explicit.h"

#include "engine/scene/text_lines.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

namespace manylight {
namespace {

enum class Kind { Colour, Number, Dissolve, Transparency, Illumination, Map, MapLeftOut, WithoutEffect };

struct Statement {
    std::string_view keyword;  // as the library spells it
    Kind kind;
};

constexpr Statement kStatements[] = {
    {"Kd", Kind::Colour},
    {"Ks", Kind::Colour},
    {"Ke", Kind::Colour},
    {"Ns", Kind::Number},
    {"Pr", Kind::Number},
    {"Pm", Kind::Number},
    {"Ps", Kind::Number},
    {"Pc", Kind::Number},
    {"Pcr", Kind::Number},
    {"aniso", Kind::Number},
    {"anisor", Kind::Number},
    {"d", Kind::Dissolve},
    {"Tr", Kind::Transparency},
    {"illum", Kind::Illumination},
    {"map_Kd", Kind::Map},
    {"map_Ke", Kind::Map},
    {"map_d", Kind::Map},
    {"norm", Kind::Map},
    {"bump", Kind::Map},
    {"map_bump", Kind::Map},
    {"map_Ks", Kind::MapLeftOut},
    {"map_Ns", Kind::MapLeftOut},
    {"map_Pr", Kind::MapLeftOut},
    {"map_Pm", Kind::MapLeftOut},
    {"map_Ps", Kind::MapLeftOut},
    {"map_Tr", Kind::MapLeftOut},
    {"refl", Kind::MapLeftOut},
    {"disp", Kind::MapLeftOut},
    {"map_disp", Kind::MapLeftOut},
    {"decal", Kind::MapLeftOut},
    // No part of light transport, or of refraction, which is counted with the illumination model.
    {"Ka", Kind::WithoutEffect},
    {"map_Ka", Kind::WithoutEffect},
    {"Ni", Kind::WithoutEffect},
    {"Tf", Kind::WithoutEffect},
    {"sharpness", Kind::WithoutEffect},
    {"map_aat", Kind::WithoutEffect},
};

bool equalsInAnyCase(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

const Statement* statementOf(std::string_view keyword) {
    if (equalsInAnyCase(keyword, "map_norm")) keyword = "norm";  // not in the library
    const auto found = std::find_if(std::begin(kStatements), std::end(kStatements), [&](const Statement& candidate) {
        return equalsInAnyCase(candidate.keyword, keyword);
    });
    return found == std::end(kStatements) ? nullptr : found;
}

/// "Kd r g b" or "Kd grey".
std::optional<glm::dvec3> threeNumbers(std::string_view rest) {
    const auto red = parseNumber(takeWord(rest));
    if (!red) return std::nullopt;
    const std::string_view second = takeWord(rest);
    if (second.empty() || second.front() == '#') return glm::dvec3(*red);
    const auto green = parseNumber(second);
    const auto blue = parseNumber(takeWord(rest));
    if (!green || !blue) return std::nullopt;
    return glm::dvec3(*red, *green, *blue);
}

class MtlWriter {
  public:
    MtlWriter(const std::string& file, Warnings& warnings) : file_(file), warnings_(warnings) {}

    std::string write(std::string_view text) {
        TextLines lines(text);
        while (lines.next()) {
            std::string_view rest = lines.line();
            const std::string_view keyword = takeWord(rest);
            if (keyword.empty() || keyword.front() == '#') continue;
            place_ = fmt::format("{} line {}", file_, lines.number());
            if (equalsInAnyCase(keyword, "newmtl"))
                startMaterial(trimmed(rest));
            else if (!hasMaterial_)
                warnings_.add("material statements before any newmtl ignored", place_);
            else if (const Statement* const statement = statementOf(keyword))
                writeStatement(*statement, rest);
            else
                warnings_.add("material statements of unknown meaning ignored", place_);
        }
        return std::move(written_);
    }

  private:
    /// To the library a newmtl without a name is none, and what follows would be the last material's.
    void startMaterial(std::string_view name) {
        hasMaterial_ = !name.empty();
        if (hasMaterial_)
            written_ += fmt::format("newmtl {}\n", name);
        else
            warnings_.add("materials without a name left out", place_);
    }

    void writeStatement(const Statement& statement, std::string_view rest) {
        switch (statement.kind) {
            case Kind::Colour:
                return writeColour(statement, rest);
            case Kind::Number:
                return writeNumber(statement, number(rest));
            case Kind::Dissolve:
                return writeDissolve(statement, rest);
            case Kind::Transparency:
                return writeNumber(statement, number(rest), 1.0);
            case Kind::Illumination:
                return writeIllumination(statement, rest);
            case Kind::Map:
                return writeMap(statement, rest);
            case Kind::MapLeftOut:
                warnings_.add("textures left out: only map_Kd, map_Ke, map_d, norm and bump are read", place_);
                return;
            case Kind::WithoutEffect:
                return;
        }
    }

    void write(const Statement& statement, std::string_view values) {
        written_ += fmt::format("{0} {1}\n{2}{0} 1\n", statement.keyword, values, kStatedPrefix);
    }

    void writeColour(const Statement& statement, std::string_view rest) {
        const auto numbers = threeNumbers(rest);
        if (!numbers) warnings_.add("material colours set to zero: not three numbers", place_);
        glm::dvec3 colour = numbers.value_or(glm::dvec3(0.0));
        for (int channel = 0; channel < 3; ++channel) {
            if (std::isfinite(colour[channel])) continue;
            warnings_.add("material colours set to zero: not finite", place_);
            colour[channel] = 0.0;
        }
        write(statement,
              fmt::format("{} {} {}", explicitNumber(colour.r), explicitNumber(colour.g), explicitNumber(colour.b)));
    }

    std::optional<double> number(std::string_view rest) {
        const auto value = parseNumber(takeWord(rest));
        if (value && std::isfinite(*value) && *value >= 0.0) return value;
        warnings_.add("material numbers ignored: negative or no finite number", place_);
        return std::nullopt;
    }

    void writeNumber(const Statement& statement, std::optional<double> value, double most = 1e300) {
        if (value) write(statement, explicitNumber(std::min(*value, most)));
    }

    void writeDissolve(const Statement& statement, std::string_view rest) {
        std::string_view behind = rest;
        if (takeWord(behind) == "-halo") {
            warnings_.add("opacity that depends on the view taken as constant", place_);
            rest = behind;
        }
        writeNumber(statement, number(rest));
    }

    void writeIllumination(const Statement& statement, std::string_view rest) {
        const auto model = number(rest);
        if (model && *model <= 10.0) write(statement, fmt::format("{}", static_cast<int>(*model)));
    }

    void writeMap(const Statement& statement, std::string_view rest) {
        const std::string map = explicitMap(rest, place_, warnings_);
        if (!map.empty()) written_ += fmt::format("{} {}\n", statement.keyword, map);
    }

    const std::string& file_;
    Warnings& warnings_;
    std::string place_;
    std::string written_;
    bool hasMaterial_ = false;
};

}  // namespace

std::string explicitNumber(double number) {
    constexpr double kMost = 1e300;  // the library's powers of ten are inexact: what is near the end may overflow there
    return fmt::format("{}", std::clamp(number, -kMost, kMost));
}

std::string explicitMtl(std::string_view text, const std::string& file, Warnings& warnings) {
    return MtlWriter(file, warnings).write(text);
}

}  // namespace manylight
