// Pictures of a scene whose animation is played.
#pragma once

#include "apps/capture/capture.h"

#include <string>
#include <vector>

namespace manylight {

/// Seconds of the pictures that "FROM:TO:RATE" asks for: RATE a second, both ends included. Throws Error (usage).
std::vector<double> timesOf(const std::string& range);

/// The file name with its run of # signs replaced by a number of as many digits, or more. Throws Error (usage) if there
/// is no such run in it.
std::filesystem::path numbered(const std::filesystem::path& pattern, size_t number);

/// One picture for each time. Each is written as it is done, so that an interrupted job keeps those it has.
void captureAnimation(const CaptureOptions& options);

}  // namespace manylight
