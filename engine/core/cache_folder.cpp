#include "engine/core/cache_folder.h"

#include <cstdlib>

namespace manylight {

std::optional<std::filesystem::path> cacheFolder() {
    const char* cacheHome = std::getenv("XDG_CACHE_HOME");
    const char* home = std::getenv("HOME");
    if (cacheHome != nullptr && *cacheHome != '\0') return std::filesystem::path(cacheHome) / "manylight";
    if (home != nullptr && *home != '\0') return std::filesystem::path(home) / ".cache" / "manylight";
    return std::nullopt;
}

}  // namespace manylight
