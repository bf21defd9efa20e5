// The modes that are compared: each a set of settings on top of those that all share.
#pragma once

#include "engine/techniques/settings.h"

#include <string>
#include <vector>

namespace manylight {

struct ErrorMode {
    std::string name;         // as it was asked for: "clamp=bound,vpls=64"
    RenderSettings settings;  // not yet resolved
};

inline constexpr const char* kDefaultModes[] = {"clamp=off", "clamp=bound", "clamp=compensate",
                                                "technique=path-tracer"};

/// `text` is a comma-separated list of option=value, e.g. "technique=forward,vpls=64". Throws Error (usage).
ErrorMode errorModeFrom(const std::string& text, const RenderSettings& common);

}  // namespace manylight
