// Where programs keep what they could make again.
#pragma once

#include <filesystem>
#include <optional>

namespace manylight {

/// $XDG_CACHE_HOME/manylight, else ~/.cache/manylight; empty where neither variable is set. It need not exist.
std::optional<std::filesystem::path> cacheFolder();

}  // namespace manylight
