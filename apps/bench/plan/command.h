// `manylight-bench plan`: what leaving out saves.
#pragma once

#include "apps/bench/command.h"

namespace manylight {

/// Adds the subcommand with its options to `app`.
BenchCommand addPlanCommand(CLI::App& app);

}  // namespace manylight
