// --fail-above NUMBER=VALUE.
#pragma once

#include "apps/compare/numbers.h"

namespace manylight {

struct Limit {
    std::string name;
    double largest = 0.0;
};

/// The numbers that can be limited.
std::vector<std::string> limitNames();

/// Throws Error (usage) for anything but a known name, "=" and a number.
std::vector<Limit> limitsFrom(const std::vector<std::string>& texts);

/// One phrase for every limit that is exceeded; a number that is undefined exceeds any.
std::vector<std::string> exceeded(const std::vector<Limit>& limits, const CompareNumbers& numbers);

}  // namespace manylight
