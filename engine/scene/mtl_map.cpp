#include "engine/scene/mtl_map.h"

#include "engine/scene/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace manylight {
namespace {

struct Option {
    std::string_view name;
    size_t leastWords;
    size_t mostWords;  // those past the least are taken while they are numbers
};

constexpr Option kOptions[] = {{"-o", 1, 3},      {"-s", 1, 3},         {"-t", 1, 3},  {"-bm", 1, 1},
                               {"-clamp", 1, 1},  {"-imfchan", 1, 1},   {"-mm", 2, 2}, {"-blendu", 1, 1},
                               {"-blendv", 1, 1}, {"-boost", 1, 1},     {"-cc", 1, 1}, {"-texres", 1, 1},
                               {"-type", 1, 1},   {"-colorspace", 1, 1}};

constexpr std::string_view kNoNumber = "texture options ignored: no finite number";

class MapParser {
  public:
    MapParser(const std::string& place, Warnings& warnings) : place_(place), warnings_(warnings) {}

    /// Takes options off the front of `text` and returns what is left.
    std::string_view takeOptions(std::string_view text) {
        for (;;) {
            std::string_view rest = text;
            const std::string_view word = takeWord(rest);
            const auto option = std::find_if(std::begin(kOptions), std::end(kOptions),
                                             [&](const Option& candidate) { return candidate.name == word; });
            if (option == std::end(kOptions)) return trimmed(text);
            apply(*option, rest);
            text = rest;
        }
    }

    /// Options behind a file name, which may hold blanks itself.
    std::string_view takeTrailingOptions(std::string_view name) {
        for (const Option& option : kOptions) {
            const size_t at = name.find(fmt::format(" {} ", option.name));
            if (at == std::string_view::npos) continue;
            Warnings trialWarnings;
            MapParser trial(place_, trialWarnings);
            trial.map_ = map_;
            const bool isWhole = trial.takeOptions(name.substr(at)).empty();
            if (!isWhole || trialWarnings.count(kNoNumber) > 0) continue;
            map_ = trial.map_;
            warnings_.merge(trialWarnings);
            return trimmed(name.substr(0, at));
        }
        return name;
    }

    MtlMap map_;

  private:
    void apply(const Option& option, std::string_view& rest) {
        std::array<std::string_view, 3> words{};
        size_t count = 0;
        while (count < option.mostWords) {
            std::string_view behind = rest;
            const std::string_view word = takeWord(behind);
            if (count >= option.leastWords && !parseNumber(word)) break;
            words[count++] = word;
            rest = behind;
        }
        if (option.name == "-o") map_.offset = pairOf(words, 0.0);
        if (option.name == "-s") map_.scale = pairOf(words, 1.0);
        if (option.name == "-bm") map_.bumpMultiplier = number(words[0], 1.0);
        if (option.name == "-clamp") map_.isClamped = words[0] == "on";
        if (option.name == "-imfchan") setChannel(words[0]);
        const bool changesPicture =
            option.name == "-t" || option.name == "-type" ||
            (option.name == "-mm" && (number(words[0], 0.0) != 0 || number(words[1], 1.0) != 1));
        if (changesPicture) warnings_.add("texture options ignored", fmt::format("{}: {}", place_, option.name));
    }

    double number(std::string_view word, double fallback) {
        const auto value = parseNumber(word);
        if (value && std::isfinite(*value)) return *value;
        warnings_.add(kNoNumber, place_);
        return fallback;
    }

    glm::dvec2 pairOf(const std::array<std::string_view, 3>& words, double fallback) {
        return {number(words[0], fallback), words[1].empty() ? fallback : number(words[1], fallback)};
    }

    void setChannel(std::string_view word) {
        if (word.size() == 1 && std::string_view("rgbml").find(word.front()) != std::string_view::npos)
            map_.channel = word.front();
        else
            warnings_.add("texture options ignored", fmt::format("{}: -imfchan", place_));
    }

    const std::string& place_;
    Warnings& warnings_;
};

}  // namespace

std::optional<MtlMap> parseMtlMap(std::string_view text, const std::string& place, Warnings& warnings) {
    MapParser parser(place, warnings);
    parser.map_.file = parser.takeTrailingOptions(parser.takeOptions(text));
    if (!parser.map_.file.empty()) return parser.map_;
    warnings.add("textures left out: no file name", place);
    return std::nullopt;
}

}  // namespace manylight
