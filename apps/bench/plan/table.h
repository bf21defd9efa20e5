// The results of `manylight-bench plan` as text, CSV and JSON.
#pragma once

#include "apps/bench/plan/measure.h"

namespace manylight {

std::string planTable(const PlanRun& run);
std::string planCsv(const PlanRun& run);
Json planJson(const PlanOptions& options, const PlanRun& run);

/// Variants whose picture differs from the planned one by more than kPlanTolerance.
size_t otherPictures(const PlanRun& run);

}  // namespace manylight
