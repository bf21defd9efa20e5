// manylight-bench error: error against run time, each technique against a converged reference.
#pragma once

#include "apps/bench/command.h"

namespace manylight {

/// Adds the subcommand with its options to `app`.
BenchCommand addErrorCommand(CLI::App& app);

}  // namespace manylight
