// Plots are drawn by Python scripts with matplotlib; this runs them.
#pragma once

#include "engine/core/report.h"

#include <filesystem>
#include <string>

namespace manylight {

/// Throws Error if `picture` is no name of a plot, or could not be written. Empty is no plot.
void checkPlotFile(const std::string& picture);

/// Gives `data` to `script` (of the project's scripts/) and has it write `picture`, atomically. The interpreter is
/// $MANYLIGHT_PYTHON, else /usr/bin/python3, else python3 of the PATH. Without it, or without matplotlib, prints one
/// line on standard error and returns false: the numbers matter more than their picture.
bool drawPlot(const std::string& script, const Json& data, const std::filesystem::path& picture);

}  // namespace manylight
