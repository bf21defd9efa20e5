// manylight-bench rays: the speed and the correctness of ray casting, beside Embree's single-ray queries.
#pragma once

#include "apps/bench/command.h"

namespace manylight {

/// Adds the subcommand with its options to `app`.
BenchCommand addRaysCommand(CLI::App& app);

}  // namespace manylight
