#include "apps/bench/error_mode.h"

#include "apps/common/command_line.h"
#include "engine/core/error.h"

#include <sstream>

namespace manylight {

ErrorMode errorModeFrom(const std::string& text, const RenderSettings& common) {
    ErrorMode mode{text, common};
    std::istringstream list(text);
    TypedSettings typed;
    for (std::string entry; std::getline(list, entry, ',');) {
        const size_t equals = entry.find('=');
        if (equals == std::string::npos)
            failUsage("--mode {}: expected option=value,... like technique=deferred,clamp=bound", text);
        const std::string option = entry.substr(0, equals);
        for (const char* fixed : {"seed", "size", "camera", "show", "lighting", "bounces"})
            if (option == fixed) failUsage("--mode {}: --{} is the same for all modes", text, fixed);
        typed.emplace_back(option, entry.substr(equals + 1));
    }
    applyTyped(mode.settings, typed);
    mode.settings.jitter = true;
    return mode;
}

}  // namespace manylight
