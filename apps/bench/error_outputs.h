// The results of `manylight-bench error` as text, CSV, JSON and pictures.
#pragma once

#include "apps/bench/error_summary.h"

namespace manylight {

std::string errorTable(const ErrorOptions& options, const ErrorRun& run, const ErrorSummary& summary);
std::string errorCsv(const ErrorSummary& summary);
Json errorJson(const ErrorOptions& options, const ErrorRun& run, const ErrorSummary& summary);

/// reference.exr and .png, and for every mode its last picture of the first seed as mode-N.exr and .png.
void writePictures(const std::filesystem::path& folder, const ErrorRun& run);

}  // namespace manylight
