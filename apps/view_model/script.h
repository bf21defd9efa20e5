// Scripted input: one command a line, the same commands that keys and buttons give.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace manylight {

/// Words of one command, the name first. `place` is where it stands, for messages.
struct Command {
    std::vector<std::string> words;
    std::string place;

    const std::string& name() const { return words.front(); }
    /// Number `index`, counted from 1 behind the name. Throws Error naming the place.
    double number(size_t index) const;
    /// The same, of a whole number in a range.
    uint32_t whole(size_t index, uint32_t low, uint32_t high) const;
};

/// What there is to type.
struct CommandHelp {
    const char* name;
    const char* arguments;
    size_t fewest;  // arguments
    size_t most;
    const char* help;
};
const std::vector<CommandHelp>& commandHelps();

/// Splits at spaces; "..." keeps them. Throws Error for an unknown name or a wrong number of arguments.
Command parseCommand(std::string_view line, const std::string& place);

/// A script: '#' begins a comment. Throws Error naming file and line.
std::vector<Command> parseScript(std::string_view text, const std::string& file);

}  // namespace manylight
