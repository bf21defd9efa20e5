// Which key gives which command.
#pragma once

#include <string>
#include <vector>

namespace manylight {

struct KeyBinding {
    const char* key;      // as script and help name it: "t", "f1", "tab"
    const char* command;  // see commandHelps(); empty: held down, it moves the camera
    const char* help;
};
const std::vector<KeyBinding>& keyBindings();

/// What a key gives when it is pressed; empty if nothing.
std::string commandOfKey(const std::string& key);

}  // namespace manylight
