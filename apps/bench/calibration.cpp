#include "apps/bench/calibration.h"

#include "engine/core/statistics.h"

#include <chrono>
#include <cstdint>

namespace manylight {
namespace {

float dependentWork() {
    constexpr int kSteps = 8'000'000;
    uint32_t state = 1;
    float sum = 0.0f;
    for (int i = 0; i < kSteps; ++i) {
        state = state * 1664525u + 1013904223u;
        sum = sum * 0.75f + static_cast<float>(state >> 8);
    }
    return sum;
}

}  // namespace

double calibrationMilliseconds() {
    std::vector<double> times;
    for (int i = 0; i < 3; ++i) {
        const auto start = std::chrono::steady_clock::now();
        const volatile float kept = dependentWork();  // volatile: the loop must run
        static_cast<void>(kept);
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    return median(times);
}

}  // namespace manylight
