// Choosing among many by one look-up (Walker 1977), with Vose's way to build the table (1991).
#pragma once

#include <cstdint>
#include <vector>

namespace manylight {

/// A slot is drawn evenly, then a number in [0, 1): below `threshold` the slot's own number is the choice, else
/// `alias`.
struct AliasSlot {
    float threshold = 1.0f;
    uint32_t alias = 0;
};

/// One slot for each of `weights`, which are finite and not negative, with a sum above zero. A weight of zero is never
/// chosen. Fewer than 2^32.
std::vector<AliasSlot> buildAliasTable(const std::vector<double>& weights);

}  // namespace manylight
