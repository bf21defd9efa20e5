// manylight-bench fps: frames per second over VPL counts, forward against deferred, as in Table 1 and Figure 6 of
// KhemlicheBabahenini.
#pragma once

#include "apps/bench/command.h"

namespace manylight {

/// Adds the subcommand with its options to `app`.
BenchCommand addFpsCommand(CLI::App& app);

}  // namespace manylight
