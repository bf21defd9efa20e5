// The probe of latency, on a clock of the test's own.
#include "apps/view_model/latency_probe.h"

#include <gtest/gtest.h>

namespace manylight {
namespace {

/// Frames of `frame` seconds; what was asked for is shown `delay` frames later than at once.
LatencyProbe probeOf(double frame, uint32_t delay, uint32_t inputs) {
    LatencyProbe probe;
    probe.start(inputs);
    double now = 0.0;
    uint32_t framesLeft = 0;
    bool isOnItsWay = false;
    for (int i = 0; i < 1000 && probe.isRunning() && !probe.isLost(); ++i) {
        if (probe.takeInput(now)) {
            isOnItsWay = true;
            framesLeft = delay;
        }
        now += frame;
        const bool shows = isOnItsWay && framesLeft == 0;
        if (isOnItsWay && !shows) --framesLeft;
        probe.presented(now, shows);
        if (shows) isOnItsWay = false;
    }
    return probe;
}

TEST(LatencyProbe, AFrameThatShowsItsInputIsOneToTwoFramesLate) {
    const LatencyProbe probe = probeOf(0.04, 0, 50);
    ASSERT_EQ(probe.samples().size(), 50u);
    for (const LatencyProbe::Sample& sample : probe.samples()) {
        EXPECT_GT(sample.frames, 1.0);
        EXPECT_LT(sample.frames, 2.0);
        EXPECT_NEAR(sample.seconds, 0.04 * sample.frames, 1e-9);
    }
    EXPECT_NEAR(probe.medianFrames(), 1.5, 0.05) << "inputs come at any moment of a frame";
    EXPECT_NEAR(probe.medianSeconds(), 0.06, 0.002);
    EXPECT_GT(probe.mostFrames(), 1.9);
}

TEST(LatencyProbe, AFrameMoreIsSeen) {
    EXPECT_NEAR(probeOf(0.04, 1, 50).medianFrames(), 2.5, 0.05);
    EXPECT_NEAR(probeOf(0.04, 2, 50).medianFrames(), 3.5, 0.05);
}

TEST(LatencyProbe, GivesUpWhereNothingFollows) {
    const LatencyProbe probe = probeOf(0.04, 500, 3);
    EXPECT_TRUE(probe.isLost());
    EXPECT_TRUE(probe.samples().empty());
}

}  // namespace
}  // namespace manylight
