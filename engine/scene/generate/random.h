// Pseudo-random numbers for the scene generators: the same on every platform for the same seed.
#pragma once

#include "shaders/shared/constants.h"

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>

namespace manylight {

/// SplitMix64 (Steele, Lea and Flood 2014). The distributions of the standard library differ between platforms.
class SceneRandom {
  public:
    explicit SceneRandom(uint64_t seed) : state_(seed) {}

    uint64_t next() {
        state_ += 0x9e3779b97f4a7c15u;
        uint64_t mixed = (state_ ^ (state_ >> 30)) * 0xbf58476d1ce4e5b9u;
        mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebu;
        return mixed ^ (mixed >> 31);
    }
    /// Uniform in [0, 1), a multiple of 2^-53.
    double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    uint32_t below(uint32_t count) { return static_cast<uint32_t>((next() >> 32) * count >> 32); }

  private:
    uint64_t state_;
};

/// Of a full circle.
inline double uniformAngle(SceneRandom& random) { return 2.0 * double{shared::kPi} * random.unit(); }

inline glm::dvec3 uniformDirection(SceneRandom& random) {
    const double y = random.between(-1.0, 1.0);
    const double around = uniformAngle(random);
    const double r = std::sqrt(1.0 - y * y);
    return {r * std::cos(around), y, r * std::sin(around)};
}

}  // namespace manylight
