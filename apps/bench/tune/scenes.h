// The scenes that a tuning is measured on.
#pragma once

#include "apps/bench/tune/options.h"
#include "engine/scene/scene.h"

namespace manylight {

/// Those that were asked for, or the Cornell box and the courtyard, generated. Throws Error.
std::vector<Scene> scenesOf(const TuneOptions& options);

}  // namespace manylight
