#include "engine/scene/alias_table.h"

#include "engine/core/check.h"

#include <algorithm>
#include <numeric>

namespace manylight {

std::vector<AliasSlot> buildAliasTable(const std::vector<double>& weights) {
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    MANYLIGHT_CHECK(total > 0.0, "{} weights", weights.size());
    const double scale = static_cast<double>(weights.size()) / total;
    std::vector<double> left(weights.size());  // what of each weight is not yet in a slot, in slots
    std::vector<uint32_t> small;
    std::vector<uint32_t> large;
    for (uint32_t i = 0; i < weights.size(); ++i) {
        left[i] = weights[i] * scale;
        (left[i] < 1.0 ? small : large).push_back(i);
    }
    std::vector<AliasSlot> slots(weights.size());
    // Every slot that its own entry does not fill is filled up by one that has more than a slot.
    while (!small.empty() && !large.empty()) {
        const uint32_t filled = small.back();
        const uint32_t giver = large.back();
        small.pop_back();
        slots[filled] = {static_cast<float>(left[filled]), giver};
        left[giver] -= 1.0 - left[filled];
        if (left[giver] >= 1.0) continue;
        large.pop_back();
        small.push_back(giver);
    }
    // Rounding may leave slots over. They are full, but those of entries that must not be chosen.
    const auto largest = static_cast<uint32_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
    for (const uint32_t i : large) slots[i] = {1.0f, i};
    for (const uint32_t i : small) slots[i] = weights[i] > 0.0 ? AliasSlot{1.0f, i} : AliasSlot{0.0f, largest};
    return slots;
}

}  // namespace manylight
