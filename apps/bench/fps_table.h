// The report of `manylight-bench fps` as text.
#pragma once

#include "apps/bench/fps_summary.h"

namespace manylight {

std::string fpsTable(const FpsOptions& options, const FpsRun& run, const FpsSummary& summary);

}  // namespace manylight
