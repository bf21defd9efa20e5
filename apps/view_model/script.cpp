#include "apps/view_model/script.h"

#include "engine/core/error.h"

#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace manylight {
namespace {

std::vector<std::string> split(std::string_view line, const std::string& place) {
    std::vector<std::string> words;
    std::optional<std::string> word;
    bool isQuoted = false;
    for (const char c : line) {
        const bool isSpace = c == ' ' || c == '\t' || c == '\r';
        if (!isQuoted && c == '#') break;
        if (c == '"') {
            isQuoted = !isQuoted;
            if (!word) word.emplace();
        } else if (isSpace && !isQuoted) {
            if (word) words.push_back(*std::exchange(word, std::nullopt));
        } else {
            if (!word) word.emplace();
            word->push_back(c);
        }
    }
    if (isQuoted) fail("{}: expected a second quotation mark", place);
    if (word) words.push_back(*word);
    return words;
}

const CommandHelp& helpOf(const std::string& name, const std::string& place) {
    std::vector<const char*> known;
    for (const CommandHelp& help : commandHelps()) {
        if (name == help.name) return help;
        known.push_back(help.name);
    }
    fail("{}: unknown command '{}', expected one of {}", place, name, fmt::join(known, ", "));
}

}  // namespace

const std::vector<CommandHelp>& commandHelps() {
    static const std::vector<CommandHelp> helps = {
        {"set", "NAME VALUE", 2, 2, "change a setting; other.NAME: of the other side"},
        {"next", "NAME", 1, 1, "the next choice of a setting"},
        {"camera", "N", 1, 1, "look through one of the scene's cameras"},
        {"reset-view", "", 0, 0, "look through the camera again"},
        {"copy-view", "", 0, 0, "the view as a sidecar's JSON, to the clipboard"},
        {"save-view", "[FILE.json]", 0, 1, "the scene, view, lights and settings as a sidecar"},
        {"capture", "[FILE.png|.exr]", 0, 1, "the picture without panels; EXR with its settings"},
        {"screenshot", "[FILE.png]", 0, 1, "the window as it is"},
        {"report", "FILE.json", 1, 1, "sizes, times and errors as JSON"},
        {"open", "FILE", 1, 1, "another scene"},
        {"add-light", "TYPE", 1, 1, "point, spot or directional, before the camera"},
        {"light", "N brightness|position|direction|remove VALUE...", 2, 5, "change a light"},
        {"emission", "N FACTOR", 2, 2,
         "what emissive surface N of the list emits, as a multiple of what its file says"},
        {"undo", "", 0, 0, "take back the last change of lights"},
        {"fps-table", "[VPLS...|off]", 0, 8,
         "measure forward and deferred over VPL counts; once more: stop; off: close"},
        {"latency", "[INPUTS]", 0, 1, "measure how long the picture takes to follow the mouse"},
        {"restart", "", 0, 0, "forget the frames so far"},
        {"key", "NAME [FRAMES]", 1, 2, "hold a key down"},
        {"drag", "left|right DX DY [FRAMES]", 3, 4, "move the mouse with a button down, pixels a frame"},
        {"wheel", "NOTCHES", 1, 1, "turn the mouse wheel"},
        {"click", "X Y", 2, 2, "press and release the left mouse button on a panel, at a pixel of the window"},
        {"resize", "WIDTH HEIGHT", 2, 2, "the window's size"},
        {"iconify", "", 0, 0, "minimise the window"},
        {"restore", "", 0, 0, "show it again"},
        {"drop", "FILE...", 1, 8, "drop files onto the window"},
        {"wait", "FRAMES", 1, 1, "show so many frames"},
        {"wait-for", "FILE", 1, 1, "show frames until the file exists"},
        {"watch", "", 0, 0, "look at the shaders now (--watch-shaders)"},
        {"frames", "N", 1, 1, "wait until the picture is the mean of N frames, and hold it there"},
        {"quit", "", 0, 0, "end the program"},
    };
    return helps;
}

double Command::number(size_t index) const {
    double value = 0.0;
    const std::string& text = words.at(index);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
        fail("{}: {}: expected a number, found '{}'", place, name(), text);
    return value;
}

uint32_t Command::whole(size_t index, uint32_t low, uint32_t high) const {
    const double value = number(index);
    if (!(value >= low && value <= high) || value != std::floor(value))
        fail("{}: {}: expected a whole number from {} to {}, found {}", place, name(), low, high, words[index]);
    return static_cast<uint32_t>(value);
}

Command parseCommand(std::string_view line, const std::string& place) {
    Command command{split(line, place), place};
    if (command.words.empty()) fail("{}: expected a command", place);
    const CommandHelp& help = helpOf(command.name(), place);
    const size_t count = command.words.size() - 1;
    if (count < help.fewest || count > help.most)
        fail("{}: {}: expected {}", place, help.name, help.most == 0 ? "no arguments" : help.arguments);
    return command;
}

std::vector<Command> parseScript(std::string_view text, const std::string& file) {
    std::vector<Command> commands;
    size_t number = 0;
    for (size_t start = 0; start < text.size(); ++number) {
        const size_t end = std::min(text.find('\n', start), text.size());
        const std::string_view line = text.substr(start, end - start);
        const std::string place = fmt::format("{}: line {}", file, number + 1);
        if (!split(line, place).empty()) commands.push_back(parseCommand(line, place));
        start = end + 1;
    }
    return commands;
}

}  // namespace manylight
