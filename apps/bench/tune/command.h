// `manylight-bench tune`: sizes of workgroups and the like that suit a device.
#pragma once

#include "apps/bench/command.h"

namespace manylight {

/// Adds the subcommand with its options to `app`.
BenchCommand addTuneCommand(CLI::App& app);

}  // namespace manylight
