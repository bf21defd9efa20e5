// How long it takes until the window shows what an input did.
#pragma once

#include <cstdint>
#include <vector>

namespace manylight {

/// Pretends inputs at moments spread evenly over a frame, as those of a user are, and waits each time for the frame
/// that shows what it did. Times are seconds on one clock.
class LatencyProbe {
  public:
    struct Sample {
        double seconds = 0.0;  // from the input to the end of the frame that shows it
        double frames = 0.0;   // that, in mean durations of the frames in which it fell
    };

    void start(uint32_t sampleCount);
    void stop() { left_ = 0; }
    bool isRunning() const { return left_ > 0; }
    /// When a frame asks for input: true if one has come, which the frame must take up.
    bool takeInput(double now);
    /// When a frame has been drawn and presented.
    void presented(double now, bool showsInput);
    /// No frame showed the last input though many might have.
    bool isLost() const { return framesSinceInput_ > kMostFrames; }

    const std::vector<Sample>& samples() const { return samples_; }
    double medianFrames() const;
    double mostFrames() const;
    double medianSeconds() const;

  private:
    static constexpr uint32_t kMostFrames = 50;

    uint32_t left_ = 0;
    double lastPresented_ = -1.0;
    double inputAt_ = -1.0;     // seconds; negative: none is on its way
    double windowStart_ = 0.0;  // start of the frame in which the input comes
    bool isTaken_ = false;
    uint32_t framesSinceInput_ = 0;
    std::vector<Sample> samples_;
};

}  // namespace manylight
