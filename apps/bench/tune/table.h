// The results of `manylight-bench tune` as text, CSV and JSON.
#pragma once

#include "apps/bench/tune/measure.h"

namespace manylight {

std::string tuneTable(const TuneRun& run);
std::string tuneCsv(const TuneRun& run);
Json tuneJson(const TuneOptions& options, const TuneRun& run);

/// Candidates whose pictures differ from the default's: there must be none.
size_t otherPictures(const TuneRun& run);

/// Whether whole frames are faster with all that was chosen: the median of their ratios is below 1.
bool isWorthKeeping(const TuneRun& run);

}  // namespace manylight
