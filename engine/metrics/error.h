// How far a picture is from its reference, in numbers: docs/measuring-error.md has the formulas.
#pragma once

#include "engine/metrics/pixel_use.h"

#include <array>
#include <optional>

namespace manylight {

/// Added to squares and sums of values that were divided by the reference's mean luminance.
constexpr double kRelativeErrorEpsilon = 0.01;
/// Share of the pixels that counts as the worst; at least one pixel.
constexpr double kWorstPixelShare = 0.001;

/// v is the test picture, r the reference; means run over the compared pixels and their three channels. Sums are in
/// double and in the order of the pixels.
struct ErrorReport {
    uint64_t pixels = 0;  // compared
    uint64_t maskedOut = 0;
    uint64_t nonFinite = 0;  // pixels left out of everything below: some channel of one of the pictures is not finite
    uint64_t nonFiniteTest = 0;
    uint64_t nonFiniteReference = 0;

    double meanLuminanceReference = 0.0;
    std::array<double, 3> meanTest{};
    std::array<double, 3> meanReference{};

    double rmse = 0.0;  // sqrt(mean (v - r)²), in the pictures' own unit
    // Of v and r divided by the reference's mean luminance, so in no unit; empty unless that mean is positive.
    std::optional<double> relativeMse;  // mean (v - r)² / (r² + 0.01)
    std::optional<double> smape;        // mean |v - r| / (|v| + |r| + 0.01)

    uint64_t worstPixels = 0;       // how many make up the worst 0.1 %
    double worstShare = 0.0;        // of the sum of squared errors, in these pixels; 0 where there is no error
    double rmseWithoutWorst = 0.0;  // 0 if no other pixel is left
};

/// Compares two pictures of three channels and one size. Throws Error if no pixel is left to compare.
ErrorReport compareImages(const Image& test, const Image& reference, const Mask* mask = nullptr);

/// meanTest / meanReference of a channel; empty for a mean of zero.
std::optional<double> meanRatio(const ErrorReport& report, size_t channel);

}  // namespace manylight
