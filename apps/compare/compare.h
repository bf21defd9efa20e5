// One comparison, from two files to numbers and pictures.
#pragma once

#include "engine/metrics/flip.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace manylight {

enum class FlipKind { Auto, Hdr, Ldr, Off };

struct CompareOptions {
    std::filesystem::path test;
    std::filesystem::path reference;
    std::string layer;  // of both EXR files; empty: the main image
    std::filesystem::path mask;
    std::string crop;  // x,y,w,h; empty: everything
    FlipKind flip = FlipKind::Auto;
    double pixelsPerDegree = kDefaultPixelsPerDegree;
    bool json = false;  // on standard output, instead of the text
    std::filesystem::path jsonFile;
    std::filesystem::path difference;
    std::optional<double> differenceRange;  // relative error at the ends of the colour scale; empty: chosen
    std::filesystem::path flipMap;
    std::vector<std::string> failAbove;  // METRIC=VALUE
    bool allowNonFinite = false;
};

/// Prints the numbers and writes the files. Throws Error, after that, where pixels are not finite or a limit is
/// exceeded; at once for what cannot be read, written or compared.
void compare(const CompareOptions& options);

}  // namespace manylight
