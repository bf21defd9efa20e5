#include "engine/core/error.h"

#include <algorithm>

namespace manylight {

std::string printable(std::string_view text) {
    std::string line(text);
    const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
    std::replace_if(line.begin(), line.end(), isControl, '?');
    return line;
}

Error::Error(const std::string& message, int exitCode) : std::runtime_error(printable(message)), exitCode_(exitCode) {}

}  // namespace manylight
