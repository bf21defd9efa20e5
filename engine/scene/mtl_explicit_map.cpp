#include "engine/scene/mtl_explicit.h"
#include "engine/scene/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

// The library takes the words behind "-o" and "-s" for three numbers, whatever they are ("-s 2 2 a.png" loses the
// name), takes options behind a name for part of it, and lets those of a statement linger in the next of its kind.

namespace manylight {
namespace {

enum class Kind { Numbers, Word, WithoutEffect };

struct Option {
    std::string_view name;
    Kind kind;
    int mostNumbers = 0;                  // at least one
    std::string_view missingNumber = {};  // those past the first
};

constexpr Option kOptions[] = {{"-o", Kind::Numbers, 3, "0"},    {"-s", Kind::Numbers, 3, "1"},
                               {"-t", Kind::Numbers, 3, "0"},    {"-bm", Kind::Numbers, 1},
                               {"-mm", Kind::Numbers, 2, "1"},   {"-clamp", Kind::Word},
                               {"-imfchan", Kind::Word},         {"-type", Kind::Word},
                               {"-boost", Kind::WithoutEffect},  {"-cc", Kind::WithoutEffect},
                               {"-blendu", Kind::WithoutEffect}, {"-blendv", Kind::WithoutEffect},
                               {"-texres", Kind::WithoutEffect}, {"-colorspace", Kind::WithoutEffect}};

constexpr std::string_view kUnlessSaid = "-o 0 0 0 -s 1 1 1 -t 0 0 0 -bm 1 -mm 0 1 -clamp off -imfchan l -type none";

struct Options {
    std::string written;
    int malformedCount = 0;
};

void takeNumbers(const Option& option, std::string_view& rest, Options& options) {
    std::string written = fmt::format(" {}", option.name);
    bool isSound = true;
    for (int i = 0; i < option.mostNumbers; ++i) {
        std::string_view behind = rest;
        const auto number = parseNumber(takeWord(behind));
        if (number || i == 0) rest = behind;
        if (i == 0 || number) isSound = isSound && number && std::isfinite(*number);
        written += fmt::format(" {}", number ? explicitNumber(*number) : std::string(option.missingNumber));
    }
    if (isSound) options.written += written;
    if (!isSound) ++options.malformedCount;
}

void takeOption(const Option& option, std::string_view& rest, Options& options) {
    if (option.kind == Kind::Numbers) return takeNumbers(option, rest, options);
    std::string_view word = takeWord(rest);
    if (option.name == "-imfchan" && word.size() != 1) word = "?";  // the library would pass over it
    if (option.kind == Kind::Word) options.written += fmt::format(" {} {}", option.name, word);
}

/// Takes options off the front of `text` and returns what is left.
std::string_view takeOptions(std::string_view text, Options& options) {
    for (;;) {
        std::string_view rest = text;
        const std::string_view word = takeWord(rest);
        const auto option = std::find_if(std::begin(kOptions), std::end(kOptions),
                                         [&](const Option& candidate) { return candidate.name == word; });
        if (option == std::end(kOptions)) return trimmed(text);
        takeOption(*option, rest, options);
        text = rest;
    }
}

/// Takes options off the end, as some programs write them, and returns the name before them, which may hold blanks.
std::string_view takeTrailingOptions(std::string_view name, Options& options) {
    for (const Option& option : kOptions) {
        const size_t at = name.find(fmt::format(" {} ", option.name));
        if (at == std::string_view::npos) continue;
        Options trial;
        if (!takeOptions(name.substr(at), trial).empty() || trial.malformedCount > 0) continue;
        options.written += trial.written;
        return trimmed(name.substr(0, at));
    }
    return name;
}

}  // namespace

std::string explicitMap(std::string_view text, const std::string& place, Warnings& warnings) {
    Options options;
    const std::string_view name = takeTrailingOptions(takeOptions(text, options), options);
    for (int i = 0; i < options.malformedCount; ++i) warnings.add("texture options ignored: no finite number", place);
    if (name.empty()) {
        warnings.add("textures left out: no file name", place);
        return {};
    }
    return fmt::format("{}{} {}", kUnlessSaid, options.written, name);
}

}  // namespace manylight
