#include "engine/passes/shading_work.h"

#include <gtest/gtest.h>

namespace manylight {
namespace {

struct Case {
    uint32_t lights;
    uint32_t vpls;
    uint32_t limit;
};

class ShadingStretches : public testing::TestWithParam<Case> {};

TEST_P(ShadingStretches, CoverEveryLightAndVplOnceWithinTheLimit) {
    const auto [lights, vpls, limit] = GetParam();
    const auto stretches = shadingStretches(lights, vpls, limit, true);
    uint32_t light = 0;
    uint32_t vpl = 0;
    for (const shared::ShadePush& push : stretches) {
        EXPECT_EQ(push.firstLight, light);
        EXPECT_EQ(push.firstVpl, vpl);
        EXPECT_LE(push.lightCount + push.vplCount, limit);
        EXPECT_EQ(push.firstVpl % shared::kVplPadding, 0u);  // never inside a subgroup's block
        EXPECT_EQ(push.showEmission, &push == &stretches.front() ? 1u : 0u);
        light += push.lightCount;
        vpl += push.vplCount;
    }
    EXPECT_EQ(light, lights);
    EXPECT_EQ(vpl, vpls);
}

INSTANTIATE_TEST_SUITE_P(Counts, ShadingStretches,
                         testing::Values(Case{0, 0, 256}, Case{1, 0, 256}, Case{0, 1, 256}, Case{3, 800, 256},
                                         Case{255, 1, 256}, Case{256, 256, 256}, Case{257, 300, 256},
                                         Case{1000, 5000, 1024}, Case{0, 1u << 20, 8192}));

TEST(RowsPerDispatch, StayBelowTheWorkThatADispatchMayDo) {
    for (const uint32_t width : {1u, 17u, 512u, 4096u, 16384u})
        for (const uint32_t work : {0u, 1u, 50u, 256u, 8192u})
            for (const uint32_t most : {1u << 24, 1u << 30})
                for (const uint32_t step : {8u, 64u}) {
                    const uint32_t rows = rowsPerDispatch(width, work, most, step);
                    ASSERT_GE(rows, step);
                    ASSERT_EQ(rows % step, 0u);
                    // One step of rows is the least that there is.
                    ASSERT_TRUE(rows == step || uint64_t{rows} * width * work <= most) << width << " " << work;
                }
    EXPECT_EQ(rowsPerDispatch(4096, 256, 1u << 24, 8), 16u);
}

}  // namespace
}  // namespace manylight
