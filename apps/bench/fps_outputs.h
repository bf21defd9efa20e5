// The report of `manylight-bench fps` for programs: CSV and JSON.
#pragma once

#include "apps/bench/fps_summary.h"

namespace manylight {

/// One line a cell under a header line; times in milliseconds.
std::string fpsCsv(const FpsSummary& summary);
Json fpsJson(const FpsOptions& options, const FpsRun& run, const FpsSummary& summary);

}  // namespace manylight
