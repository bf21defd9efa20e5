#include "apps/compare/inputs.h"

#include "engine/core/error.h"
#include "engine/image/image_io.h"
#include "engine/image/srgb.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace manylight {
namespace {

namespace fs = std::filesystem;

bool isExr(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".exr";
}

Image linearFrom(const EncodedImage& encoded) {
    std::array<float, 256> linear;
    for (size_t code = 0; code < linear.size(); ++code) linear[code] = decodeSrgb(static_cast<float>(code) / 255.0f);
    Image image(encoded.width, encoded.height, 3);
    for (size_t i = 0; i < image.texels.size(); ++i) image.texels[i] = linear[encoded.rgba[i / 3 * 4 + i % 3]];
    return image;
}

/// The channels of a layer after its name, in the order of x, y, z or red, green, blue.
std::vector<std::string> suffixesOf(const fs::path& path, const std::string& layer) {
    std::vector<std::string> found;
    const std::vector<std::string> channels = exrChannelNames(path);
    for (const std::string& channel : channels)
        if (channel.size() > layer.size() && channel.starts_with(layer) && channel[layer.size()] == '.')
            found.push_back(channel.substr(layer.size() + 1));
    for (const std::vector<std::string>& known : {std::vector<std::string>{"R", "G", "B"}, {"X", "Y", "Z"}}) {
        const auto isThere = [&](const std::string& name) { return std::count(found.begin(), found.end(), name) > 0; };
        if (std::all_of(known.begin(), known.end(), isThere)) return known;
    }
    if (found.size() != 1)
        fail("{}: no layer \"{}\" of one channel, R, G, B or X, Y, Z; the file has {}", path.string(), layer,
             fmt::join(channels, ", "));
    return found;
}

/// A layer of one channel is shown as grey.
Image readLayer(const fs::path& path, const std::string& layer, const std::vector<std::string>& suffixes) {
    Image stored = readExrLayer(path, layer, suffixes);
    if (stored.channels == 3) return stored;
    Image image(stored.width, stored.height, 3);
    for (size_t i = 0; i < image.texels.size(); ++i) image.texels[i] = stored.texels[i / 3];
    return image;
}

void readPictures(const CompareOptions& options, CompareInputs& inputs) {
    inputs.isDisplay = !isExr(options.test);
    if (inputs.isDisplay == isExr(options.reference))
        fail("{} and {}: one holds radiance, the other displayed colours: expected two EXR files, or none",
             options.test.string(), options.reference.string());
    if (inputs.isDisplay) {
        if (!options.layer.empty()) failUsage("--layer {}: only EXR files have layers", options.layer);
        inputs.test = linearFrom(readImage8(options.test));
        inputs.reference = linearFrom(readImage8(options.reference));
    } else if (options.layer.empty()) {
        inputs.test = readExr(options.test);
        inputs.reference = readExr(options.reference);
    } else {
        const std::vector<std::string> suffixes = suffixesOf(options.test, options.layer);
        inputs.isColour = suffixes.front() == "R";
        inputs.test = readLayer(options.test, options.layer, suffixes);
        inputs.reference = readLayer(options.reference, options.layer, suffixes);
    }
}

void requireSameSize(const Image& image, const fs::path& path, const Image& expected, const fs::path& expectedPath) {
    if (image.width == expected.width && image.height == expected.height) return;
    fail("{} has {} x {} pixels and {} has {} x {}: expected one size", path.string(), image.width, image.height,
         expectedPath.string(), expected.width, expected.height);
}

Image readMask(const fs::path& path) { return isExr(path) ? readExr(path) : linearFrom(readImage8(path)); }

/// The scene that an EXR of manylight-capture shows, from the run report in it.
std::optional<std::string> sceneOf(const fs::path& path) {
    const std::map<std::string, std::string> attributes = readExrAttributes(path);
    const auto report = attributes.find("manylight.report");
    if (report == attributes.end()) return std::nullopt;
    const Json json = Json::parse(report->second, nullptr, false);
    if (!json.is_object() || !json.contains("scene") || !json["scene"].is_string()) return std::nullopt;
    return json["scene"].get<std::string>();
}

void warnOfAnotherScene(const CompareOptions& options, Warnings& warnings) {
    const std::optional<std::string> test = sceneOf(options.test);
    const std::optional<std::string> reference = sceneOf(options.reference);
    if (test && reference && *test != *reference)
        warnings.add("reference of another scene",
                     fmt::format("the picture shows \"{}\", the reference \"{}\"", *test, *reference));
}

}  // namespace

CompareInputs readInputs(const CompareOptions& options) {
    std::optional<Region> region;
    if (!options.crop.empty()) region = regionFrom(options.crop);
    CompareInputs inputs;
    readPictures(options, inputs);
    requireSameSize(inputs.test, options.test, inputs.reference, options.reference);
    if (!inputs.isDisplay) warnOfAnotherScene(options, inputs.warnings);

    Image mask;
    if (!options.mask.empty()) {
        mask = readMask(options.mask);
        requireSameSize(mask, options.mask, inputs.reference, options.reference);
    }
    if (region) {
        inputs.test = cut(inputs.test, *region, options.test.string());
        inputs.reference = cut(inputs.reference, *region, options.reference.string());
        if (!options.mask.empty()) mask = cut(mask, *region, options.mask.string());
    }
    if (!options.mask.empty()) inputs.mask = maskFrom(mask);
    return inputs;
}

}  // namespace manylight
