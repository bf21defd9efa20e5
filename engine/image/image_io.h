// EXR (float, named layers, attributes) and PNG. All writes are atomic: written beside, then renamed.
#pragma once

#include "engine/core/report.h"
#include "engine/image/image.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace manylight {

/// One EXR layer. `name` empty: the main image, channels R, G, B (A). Otherwise channels are "name.<suffix>", with
/// suffixes given per channel, e.g. {"X", "Y", "Z"} or {"R", "G", "B"}; all layers share one size.
struct ExrLayer {
    std::string name;
    std::vector<std::string> suffixes;  // one per channel of `image`
    Image image;
};

/// Writes 32-bit float channels (ZIP), `attributes` as string attributes. Throws Error if it cannot be written.
void writeExr(const std::filesystem::path& path, const std::vector<ExrLayer>& layers,
              const std::map<std::string, std::string>& attributes);

/// Reads the R, G, B channels (or a single Y replicated) of an EXR as a 3-channel image. Throws Error.
Image readExr(const std::filesystem::path& path);

/// Reads linear radiance, three channels, from an EXR or a Radiance file (.hdr), told apart by their content. Throws
/// Error.
Image readRadianceMap(const std::filesystem::path& path);

/// Reads one named layer with given suffixes. Throws Error listing the channels that exist.
Image readExrLayer(const std::filesystem::path& path, const std::string& name,
                   const std::vector<std::string>& suffixes);

/// Names of all channels of an EXR file, layers' names included. Throws Error.
std::vector<std::string> exrChannelNames(const std::filesystem::path& path);

/// String attributes of an EXR file.
std::map<std::string, std::string> readExrAttributes(const std::filesystem::path& path);

/// `image` holds display-referred linear values in [0, 1], 1 or 3 channels; encodes sRGB to 8 bits.
/// Values outside are clamped, non-finite ones written as magenta.
void writePng(const std::filesystem::path& path, const Image& image);

/// `rgba` holds width * height display-encoded texels; written as RGB without further conversion.
void writePng8(const std::filesystem::path& path, uint32_t width, uint32_t height, const std::vector<uint8_t>& rgba);
/// The same with its alpha channel.
void writePngRgba8(const std::filesystem::path& path, uint32_t width, uint32_t height,
                   const std::vector<uint8_t>& rgba);

/// 8-bit RGBA texels of a PNG, JPEG, TGA or BMP held in memory or on disk, as stored (no colour conversion).
struct EncodedImage {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint8_t> rgba;
};
EncodedImage readImage8(const std::filesystem::path& path);
EncodedImage readImage8(const uint8_t* bytes, size_t size, const std::string& nameForErrors);

}  // namespace manylight
