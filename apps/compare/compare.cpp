#include "apps/compare/compare.h"

#include "apps/common/command_line.h"
#include "apps/compare/inputs.h"
#include "apps/compare/limits.h"
#include "apps/compare/pictures.h"
#include "engine/core/file.h"

#include <fmt/ranges.h>

#include <cstdio>

namespace manylight {
namespace {

namespace fs = std::filesystem;

void checkOutputs(const CompareOptions& options) {
    for (const fs::path& picture : {options.difference, options.flipMap}) {
        if (picture.empty()) continue;
        if (picture.extension() != ".png") failUsage("{}: expected a name that ends in .png", picture.string());
        requireWritable(picture);
    }
    if (!options.jsonFile.empty()) requireWritable(options.jsonFile);
    if (options.flip == FlipKind::Off && !options.flipMap.empty())
        failUsage("--flip-map and --flip off: what to draw?");
    if (options.differenceRange && options.difference.empty())
        failUsage("--difference-range: expected --difference FILE.png too");
}

FlipKind flipKindOf(const CompareOptions& options, const CompareInputs& inputs) {
    if (!inputs.isColour && options.flip != FlipKind::Off &&
        (options.flip != FlipKind::Auto || !options.flipMap.empty()))
        failUsage("--layer {}: FLIP compares colours, and these are none", options.layer);
    if (!inputs.isColour) return FlipKind::Off;
    if (options.flip != FlipKind::Auto) return options.flip;
    return inputs.isDisplay ? FlipKind::Ldr : FlipKind::Hdr;
}

CompareNumbers measure(const CompareOptions& options, const CompareInputs& inputs) {
    const Mask* mask = inputs.mask ? &*inputs.mask : nullptr;
    CompareNumbers numbers;
    numbers.width = inputs.reference.width;
    numbers.height = inputs.reference.height;
    numbers.error = compareImages(inputs.test, inputs.reference, mask);
    numbers.flipKind = flipKindOf(options, inputs);
    const FlipOptions flip{options.pixelsPerDegree, mask};
    if (numbers.flipKind == FlipKind::Hdr) numbers.flip = hdrFlip(inputs.test, inputs.reference, flip);
    if (numbers.flipKind == FlipKind::Ldr) numbers.flip = ldrFlip(inputs.test, inputs.reference, flip);
    return numbers;
}

/// The pictures asked for; returns their legends.
std::string writePictures(const CompareOptions& options, const CompareInputs& inputs, const CompareNumbers& numbers) {
    std::string legends;
    if (!options.difference.empty())
        legends += writeDifference(options.difference, inputs, numbers.error, options.differenceRange);
    if (!options.flipMap.empty() && !numbers.flip)
        fail("{}: no FLIP to show: the reference is black", options.flipMap.string());
    if (!options.flipMap.empty()) legends += writeFlipMap(options.flipMap, inputs, *numbers.flip);
    return legends;
}

}  // namespace

void compare(const CompareOptions& options) {
    checkOutputs(options);
    const std::vector<Limit> limits = limitsFrom(options.failAbove);
    CompareInputs inputs = readInputs(options);
    const CompareNumbers numbers = measure(options, inputs);
    inputs.warnings.add("pixels left out: not finite", {}, numbers.error.nonFinite);
    printWarnings(inputs.warnings);

    const std::string json = numbersToJson(options, numbers, inputs.warnings).dump(2) + "\n";
    fmt::print("{}", options.json ? json : numbersToText(options, numbers));
    if (!options.jsonFile.empty()) writeTextFile(options.jsonFile, json);
    const std::string legends = writePictures(options, inputs, numbers);
    // Standard output is the JSON's alone.
    if (!legends.empty()) fmt::print(options.json ? stderr : stdout, "{}{}", options.json ? "" : "\n", legends);
    std::fflush(stdout);

    std::vector<std::string> failures = exceeded(limits, numbers);
    if (numbers.error.nonFinite > 0 && !options.allowNonFinite)
        failures.push_back(
            fmt::format("{} pixels are not finite (--allow-nonfinite accepts that)", numbers.error.nonFinite));
    if (!failures.empty()) fail("{}", fmt::join(failures, "; "));
}

}  // namespace manylight
