// Whether a float is finite, by its bits: under -ffast-math a compiler may take std::isfinite() for always true.
#pragma once

#include <bit>
#include <cstdint>

namespace manylight {

/// `bits` are those of a 32-bit float. Infinities and NaNs have every bit of the exponent set.
constexpr bool areFiniteBits(uint32_t bits) {
    constexpr uint32_t kExponent = 0x7f800000u;
    return (bits & kExponent) != kExponent;
}

constexpr bool hasFiniteBits(float value) { return areFiniteBits(std::bit_cast<uint32_t>(value)); }

}  // namespace manylight
