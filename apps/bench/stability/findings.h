// Comparisons that make a line of the stability table each. None of them takes "not finite" for equal or small.
#pragma once

#include "apps/bench/stability/case.h"
#include "engine/image/image.h"

#include <cstdint>
#include <vector>

namespace manylight {

Finding sameBytes(std::string what, const Image& image, const Image& reference);
/// Every value is 2^exponent times the reference's, which is not black.
Finding exactlyScaled(std::string what, const Image& image, const Image& reference, int exponent);
Finding allZero(std::string what, const Image& image);
Finding notBlack(std::string what, const Image& image);
/// Sum of absolute differences over the sum of the reference: at most `tolerance`. The reference is not black.
Finding closePictures(std::string what, const Image& image, const Image& reference, double tolerance);
/// |measured - expected| <= tolerance * |expected|
Finding closeTo(std::string what, double measured, double expected, double tolerance);
Finding countIs(std::string what, uint64_t measured, uint64_t expected);
Finding holds(std::string what, std::string expected, std::string measured, bool condition);
Finding shown(std::string what, std::string expected, std::string measured);

/// Within 5 standard errors of `expected`: of the some hundred comparisons of a run, chance lets one fail in a hundred
/// runs, and as seeds are fixed it does so always or never. A relative standard error above `largestError` fails: such
/// samples agree with anything.
Finding meanIs(std::string what, const std::vector<double>& samples, double expected, double largestError);
/// The same for two estimates, each with its own error.
Finding meansAgree(std::string what, const std::vector<double>& samples, const std::vector<double>& reference,
                   double largestError);

}  // namespace manylight
