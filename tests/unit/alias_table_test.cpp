// An alias table is the distribution that it was built from, entry by entry.
#include "engine/scene/alias_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace manylight {
namespace {

/// The probability of each entry, over all slots.
std::vector<double> probabilitiesOf(const std::vector<AliasSlot>& slots) {
    std::vector<double> probabilities(slots.size(), 0.0);
    for (size_t i = 0; i < slots.size(); ++i) {
        probabilities[i] += double{slots[i].threshold};
        probabilities.at(slots[i].alias) += 1.0 - double{slots[i].threshold};
    }
    for (double& p : probabilities) p /= static_cast<double>(slots.size());
    return probabilities;
}

void expectDistribution(const std::vector<double>& weights) {
    const std::vector<AliasSlot> slots = buildAliasTable(weights);
    ASSERT_EQ(slots.size(), weights.size());
    const std::vector<double> probabilities = probabilitiesOf(slots);
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    // Thresholds are rounded to floats, and a strong entry is the alias of many slots.
    for (size_t i = 0; i < weights.size(); ++i) {
        const double expected = weights[i] / total;
        EXPECT_NEAR(probabilities[i], expected, 1e-7 * (expected + 1.0 / static_cast<double>(weights.size()))) << i;
        if (weights[i] == 0.0) {
            EXPECT_EQ(probabilities[i], 0.0) << i;
        }
    }
}

TEST(AliasTable, OneEntryIsAlwaysChosen) { expectDistribution({0.3}); }

TEST(AliasTable, EqualWeightsKeepTheirSlots) {
    const std::vector<AliasSlot> slots = buildAliasTable(std::vector<double>(7, 0.1));
    for (uint32_t i = 0; i < slots.size(); ++i)
        EXPECT_TRUE(slots[i].threshold >= 1.0f - 1e-6f || slots[i].alias == i) << i;
}

TEST(AliasTable, ZerosAreNeverChosen) {
    expectDistribution({0.0, 0.0, 1.0, 0.0});
    expectDistribution({1e-30, 0.0, 0.0});
    expectDistribution({0.0, 0.1, 0.2, 0.7, 0.0});
}

TEST(AliasTable, WeightsOfTwentyOrdersOfMagnitude) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> exponent(-10.0, 10.0);
    for (const size_t count : {2u, 3u, 64u, 5000u}) {
        std::vector<double> weights(count);
        for (size_t i = 0; i < count; ++i) weights[i] = i % 9 == 5 ? 0.0 : std::pow(10.0, exponent(random));
        expectDistribution(weights);
    }
}

}  // namespace
}  // namespace manylight
