#pragma once

#include "apps/bench/command.h"

namespace manylight {

/// `manylight-bench stability`: the extreme cases, with what must happen and what did.
BenchCommand addStabilityCommand(CLI::App& app);

}  // namespace manylight
