#include "engine/core/check.h"
#include "engine/core/file.h"
#include "engine/core/finite.h"
#include "engine/image/image_io.h"
#include "engine/image/srgb.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>

#include <algorithm>
#include <cmath>

namespace manylight {

namespace {

using Rgb8 = std::array<uint8_t, 3>;
constexpr Rgb8 kNonFiniteMarker{255, 0, 255};

uint8_t encodeChannel(float linear) {
    return static_cast<uint8_t>(std::lround(255.0f * encodeSrgb(std::clamp(linear, 0.0f, 1.0f))));
}

Rgb8 encodeTexel(const float* texel, uint32_t channels) {
    const glm::vec3 linear = channels == 1 ? glm::vec3(texel[0]) : glm::vec3(texel[0], texel[1], texel[2]);
    if (!hasFiniteBits(linear.r) || !hasFiniteBits(linear.g) || !hasFiniteBits(linear.b)) return kNonFiniteMarker;
    return {encodeChannel(linear.r), encodeChannel(linear.g), encodeChannel(linear.b)};
}

void appendBytes(void* bytes, void* data, int size) {
    static_cast<std::string*>(bytes)->append(static_cast<const char*>(data), static_cast<size_t>(size));
}

void writeBytes(const std::filesystem::path& path, uint32_t width, uint32_t height, uint32_t channels,
                const void* texels) {
    std::string bytes;
    const int written = stbi_write_png_to_func(appendBytes, &bytes, static_cast<int>(width), static_cast<int>(height),
                                               static_cast<int>(channels), texels, static_cast<int>(width * channels));
    if (!written) fail("{}: cannot encode {} x {} pixels as PNG", path.string(), width, height);
    writeTextFile(path, bytes);
}

}  // namespace

void writePng(const std::filesystem::path& path, const Image& image) {
    MANYLIGHT_CHECK(image.texels.size() > 0u, "{}", path.string());
    MANYLIGHT_CHECK((image.channels == 1 || image.channels == 3), "{}", path.string());

    std::vector<Rgb8> encoded(size_t{image.width} * image.height);
    for (size_t i = 0; i < encoded.size(); ++i)
        encoded[i] = encodeTexel(&image.texels[i * image.channels], image.channels);

    writeBytes(path, image.width, image.height, 3, encoded.data());
}

void writePng8(const std::filesystem::path& path, uint32_t width, uint32_t height, const std::vector<uint8_t>& rgba) {
    MANYLIGHT_CHECK(rgba.size() == size_t{width} * height * 4, "{}", path.string());
    std::vector<Rgb8> encoded(size_t{width} * height);
    for (size_t i = 0; i < encoded.size(); ++i) encoded[i] = {rgba[i * 4], rgba[i * 4 + 1], rgba[i * 4 + 2]};
    writeBytes(path, width, height, 3, encoded.data());
}

void writePngRgba8(const std::filesystem::path& path, uint32_t width, uint32_t height,
                   const std::vector<uint8_t>& rgba) {
    MANYLIGHT_CHECK(rgba.size() == size_t{width} * height * 4, "{}", path.string());
    writeBytes(path, width, height, 4, rgba.data());
}

}  // namespace manylight
