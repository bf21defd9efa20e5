#include "engine/scene/obj_statements.h"

#include "engine/core/error.h"
#include "engine/scene/text_lines.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <unordered_map>

// OBJ is parsed here because tinyobjloader rounds decimal numbers inexactly (a file in another unit would give another
// picture), takes "nan" and garbage for zero without a word and tells no line numbers. It does parse MTL: see mtl.cpp.

namespace manylight {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

class ObjParser {
  public:
    ObjParser(std::string_view text, Warnings& warnings) : lines_(text), warnings_(warnings) {}

    ObjStatements parse() {
        while (lines_.next()) parseLine();
        return std::move(out_);
    }
    bool knewAny() const { return knewAny_; }
    bool sawUnknown() const { return sawUnknown_; }

  private:
    void warn(std::string_view kind) {
        const bool wantsPlace = warnings_.count(kind) < Warnings::kMaxExamples;
        warnings_.add(kind, wantsPlace ? fmt::format("line {}", lines_.number()) : "");
    }

    void parseLine() {
        std::string_view rest = lines_.line();
        const std::string_view keyword = takeWord(rest);
        if (keyword.empty() || keyword.front() == '#') return;
        if (keyword == "v")
            parsePosition(rest);
        else if (keyword == "f" || keyword == "fo")
            parseFace(rest);
        else if (keyword == "vn")
            out_.normals.push_back(parseVector(rest, 3));
        else if (keyword == "vt")
            out_.uvs.emplace_back(parseVector(rest, 1));
        else if (keyword == "usemtl")
            useMaterial(trimmed(rest));
        else if (keyword == "mtllib")
            out_.materialLibraries.emplace_back(trimmed(rest));
        else if (keyword == "l" || keyword == "p")
            warn("line and point elements dropped");
        else
            return parseOther(keyword);
        knewAny_ = true;
    }

    void parseOther(std::string_view keyword) {
        static constexpr std::string_view kWithoutEffect[] = {
            "g", "o", "s", "mg", "lod", "bevel", "shadow_obj", "trace_obj", "c_interp", "d_interp", "usemap", "maplib"};
        if (std::find(std::begin(kWithoutEffect), std::end(kWithoutEffect), keyword) != std::end(kWithoutEffect)) {
            knewAny_ = true;
            return;
        }
        sawUnknown_ = true;
        warn("statements ignored: not part of polygonal OBJ");
    }

    /// Up to three numbers, at least `required`; the others are zero. NaN throughout if the line is malformed.
    glm::dvec3 parseVector(std::string_view& rest, int required) {
        glm::dvec3 vector(0.0);
        for (int i = 0; i < 3; ++i) {
            const std::string_view word = takeWord(rest);
            if ((word.empty() || word.front() == '#') && i >= required) break;
            const std::optional<double> number = parseNumber(word);
            if (!number) {
                warn("malformed vertex data: not a number");
                return glm::dvec3(kNaN);
            }
            vector[i] = *number;
        }
        return vector;
    }

    void parsePosition(std::string_view rest) {
        out_.positions.push_back(parseVector(rest, 3));
        std::vector<double>& more = extraNumbers_;
        more.clear();
        while (const auto number = parseNumber(takeWord(rest))) more.push_back(*number);
        if (more.size() >= 3 || !out_.colours.empty()) out_.colours.resize(out_.positions.size(), glm::dvec3(1.0));
        if (more.size() >= 3) out_.colours.back() = {more[more.size() - 3], more[more.size() - 2], more.back()};
        if (more.size() != 3 && !more.empty() && more.front() != 1.0) warn("vertex weights ignored");
    }

    /// Reads an index at the start of `word` and makes it count from zero. Empty if there is no number.
    static std::optional<int32_t> takeIndex(std::string_view& word, size_t elementCount) {
        int64_t index = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
        if (end == word.data()) return std::nullopt;
        word.remove_prefix(static_cast<size_t>(end - word.data()));
        if (error != std::errc()) return kBadIndex;
        const int64_t fromZero = index > 0 ? index - 1 : static_cast<int64_t>(elementCount) + index;
        const bool fits = index != 0 && fromZero >= 0 && fromZero < kBadIndex;
        return fits ? static_cast<int32_t>(fromZero) : kBadIndex;
    }

    /// "v", "v/vt", "v//vn" or "v/vt/vn". False if the word is anything else.
    bool parseCorner(std::string_view word, ObjCorner& corner) const {
        const auto position = takeIndex(word, out_.positions.size());
        if (!position) return false;
        corner.position = *position;
        if (word.empty()) return true;
        if (word.front() != '/') return false;
        word.remove_prefix(1);
        corner.uv = takeIndex(word, out_.uvs.size()).value_or(kNoIndex);
        if (word.empty()) return true;
        if (word.front() != '/') return false;
        word.remove_prefix(1);
        corner.normal = takeIndex(word, out_.normals.size()).value_or(kNoIndex);
        return word.empty();
    }

    void parseFace(std::string_view rest) {
        const size_t first = out_.corners.size();
        for (std::string_view word = takeWord(rest); !word.empty() && word.front() != '#'; word = takeWord(rest)) {
            ObjCorner corner;
            if (!parseCorner(word, corner)) {
                warn("faces dropped: malformed corner");
                out_.corners.resize(first);
                return;
            }
            out_.corners.push_back(corner);
        }
        const size_t count = out_.corners.size() - first;
        if (count < 3) {
            warn("faces dropped: fewer than three corners");
            out_.corners.resize(first);
            return;
        }
        if (out_.materialNames.empty()) useMaterial("");
        out_.faces.push_back({static_cast<uint32_t>(first), static_cast<uint32_t>(count), material_, lines_.number()});
    }

    void useMaterial(std::string_view name) {
        const auto [entry, isNew] =
            materialNumbers_.try_emplace(std::string(name), static_cast<uint32_t>(out_.materialNames.size()));
        if (isNew) out_.materialNames.emplace_back(name);
        material_ = entry->second;
    }

    TextLines lines_;
    Warnings& warnings_;
    ObjStatements out_;
    std::vector<double> extraNumbers_;
    std::unordered_map<std::string, uint32_t> materialNumbers_;
    uint32_t material_ = 0;
    bool knewAny_ = false;
    bool sawUnknown_ = false;
};

}  // namespace

ObjStatements parseObj(std::string_view text, const std::string& file, Warnings& warnings) {
    ObjParser parser(text, warnings);
    ObjStatements statements = parser.parse();
    if (parser.sawUnknown() && !parser.knewAny()) fail("{}: no line is an OBJ statement (v, vt, vn, f, ...)", file);
    return statements;
}

}  // namespace manylight
