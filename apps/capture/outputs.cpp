#include "apps/capture/outputs.h"

#include "apps/capture/aovs.h"
#include "engine/core/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>

namespace manylight {
namespace {

namespace fs = std::filesystem;

std::string lowerExtension(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

/// One texel as floats: integers become numbers of the same value, so that an EXR viewer shows them.
void decodeTexel(const DumpedImage& dump, size_t pixel, float (&rgba)[4]) {
    const std::byte* texel = dump.bytes.data() + pixel * gpu::texelBytes(dump.format);
    std::fill(std::begin(rgba), std::end(rgba), 0.0f);
    uint32_t words[4] = {};
    std::memcpy(words, texel, gpu::texelBytes(dump.format));
    switch (dump.format) {
        case VK_FORMAT_R32G32B32A32_SFLOAT:
            std::memcpy(rgba, words, sizeof(rgba));
            break;
        case VK_FORMAT_D32_SFLOAT:
            std::memcpy(rgba, words, sizeof(float));
            break;
        case VK_FORMAT_R8G8B8A8_UNORM:
            for (int c = 0; c < 4; ++c) rgba[c] = static_cast<float>(words[0] >> (8 * c) & 255u) / 255.0f;
            break;
        default:
            for (int c = 0; c < 4; ++c) rgba[c] = static_cast<float>(words[c]);
    }
}

}  // namespace

DisplayImage besideEachOther(const std::vector<DisplayImage>& pictures) {
    DisplayImage row;
    row.height = pictures.front().height;
    for (const DisplayImage& picture : pictures) row.width += picture.width;
    row.rgba.resize(size_t{row.width} * row.height * 4);
    size_t left = 0;
    for (const DisplayImage& picture : pictures) {
        for (size_t y = 0; y < row.height; ++y)
            std::copy_n(picture.rgba.begin() + static_cast<ptrdiff_t>(y * picture.width * 4), picture.width * 4,
                        row.rgba.begin() + static_cast<ptrdiff_t>((y * row.width + left) * 4));
        left += picture.width;
    }
    return row;
}

void checkOutputs(const CaptureOptions& options) {
    if (!(options.secondsBudget >= 0.0)) failUsage("--time: expected a number of seconds, 0 or more");
    if (options.outputs.empty() && options.report.empty() && options.dumpGraph.empty() && !options.explain)
        failUsage("nothing to do: expected -o FILE.exr or -o FILE.png");
    for (const fs::path& output : options.outputs) {
        const std::string extension = lowerExtension(output);
        if (extension != ".exr" && extension != ".png")
            failUsage("-o {}: expected a name that ends in .exr or .png", output.string());
        if (options.sideBySide && extension == ".exr") failUsage("-o {}: --side-by-side makes a PNG", output.string());
        requireWritable(output);
    }
    if (!options.report.empty()) requireWritable(options.report);
    requireKnownAovs(options.aovs);
    const bool wantsVariance = std::find(options.aovs.begin(), options.aovs.end(), "variance") != options.aovs.end();
    if (wantsVariance && options.mostFrames() < 2)
        failUsage("--aov variance: expected at least two frames, see --frames");
    if (!options.dumpPass.empty() && options.outputs.empty())
        failUsage("--dump-pass {}: expected -o too, its files go beside the output", options.dumpPass);
}

void writeOutputs(const std::vector<fs::path>& outputs, const Image& radiance, const std::vector<ExrLayer>& aovs,
                  const DisplayImage& display, const Json& report) {
    std::vector<ExrLayer> layers = {{"", {"R", "G", "B"}, radiance}};
    layers.insert(layers.end(), aovs.begin(), aovs.end());
    std::map<std::string, std::string> attributes;
    for (const auto& [key, value] : report["settings"].items())
        attributes["manylight." + key] = value.is_string() ? value.get<std::string>() : value.dump();
    attributes["manylight.report"] = report.dump();
    for (const fs::path& output : outputs) {
        if (lowerExtension(output) == ".exr")
            writeExr(output, layers, attributes);
        else
            writePng8(output, display.width, display.height, display.rgba);
        fmt::print("{}\n", output.string());
    }
}

void writeSideBySide(const std::vector<fs::path>& outputs, const DisplayImage& display) {
    for (const fs::path& output : outputs) {
        writePng8(output, display.width, display.height, display.rgba);
        fmt::print("{}\n", output.string());
    }
}

void writeDumps(const CaptureOptions& options, const std::vector<DumpedImage>& dumped) {
    if (options.dumpPass.empty()) return;
    if (dumped.empty())
        failUsage("--dump-pass {}: no pass of this name wrote an image (--dump-graph lists them)", options.dumpPass);
    std::map<std::string, int> written;
    for (const DumpedImage& dump : dumped) {
        Image image(dump.width, dump.height, 4);
        for (size_t pixel = 0; pixel < size_t{dump.width} * dump.height; ++pixel) {
            float rgba[4];
            decodeTexel(dump, pixel, rgba);
            std::copy_n(rgba, 4, image.texels.begin() + static_cast<ptrdiff_t>(pixel * 4));
        }
        std::string resource = dump.resource;
        std::replace(resource.begin(), resource.end(), ' ', '_');
        fs::path file = options.outputs.front();
        // A pass that runs in several stretches leaves one image each: .1, .2 and so on follow the first.
        const int earlier = written[resource]++;
        const std::string stretch = earlier > 0 ? fmt::format(".{}", earlier) : "";
        file.replace_extension(fmt::format(".{}.{}{}.exr", options.dumpPass, resource, stretch));
        writeExr(file, {{"", {"R", "G", "B", "A"}, image}}, {{"manylight.pass", options.dumpPass}});
        fmt::print("{}\n", file.string());
    }
}

}  // namespace manylight
