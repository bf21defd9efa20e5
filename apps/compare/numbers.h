// All numbers of a comparison, and their two forms.
#pragma once

#include "apps/compare/compare.h"
#include "engine/core/report.h"
#include "engine/metrics/error.h"

namespace manylight {

struct CompareNumbers {
    uint32_t width = 0;  // of what was compared: the crop, if there is one
    uint32_t height = 0;
    ErrorReport error;
    FlipKind flipKind = FlipKind::Off;  // Hdr or Ldr if it was asked for
    std::optional<FlipResult> flip;     // empty: not asked for, or undefined because the reference is black
};

std::string numbersToText(const CompareOptions& options, const CompareNumbers& numbers);
Json numbersToJson(const CompareOptions& options, const CompareNumbers& numbers, const Warnings& warnings);

}  // namespace manylight
