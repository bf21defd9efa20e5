#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/image/byte_source.h"
#include "engine/image/image_io.h"

#include <cstdlib>

// Static, because other libraries of the system carry the same symbols.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_HDR
#define STBI_MAX_DIMENSIONS 32768
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC(pointer, size) std::realloc(pointer, size)
#define STBI_FREE(pointer) std::free(pointer)
#include <stb_image.h>

#include <memory>
#include <string_view>

namespace manylight {
namespace {

constexpr stbi_io_callbacks kCallbacks = byteSourceCallbacks<stbi_io_callbacks>();
constexpr uint64_t kMostTexelsPerByte = 16;  // two bytes stand for 127 values at most, a texel has four
constexpr uint64_t kMostTexels = uint64_t{1} << 26;

/// Reads a Radiance file (Ward 1991): red, green and blue share an exponent.
Image readHdr(const std::string& bytes, const std::string& file) {
    const ByteSource start{reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()};
    ByteSource header = start;
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_callbacks(&kCallbacks, &header, &width, &height, &channels)) {
        const uint64_t texels = static_cast<uint64_t>(width) * static_cast<uint64_t>(height);
        if (texels > kMostTexels) fail("{}: {} x {} texels are more than are read", file, width, height);
        if (texels > kMostTexelsPerByte * bytes.size())
            fail("{}: image is truncated or damaged: {} bytes cannot hold {} x {} texels", file, bytes.size(), width,
                 height);
    }
    ByteSource source = start;
    const std::unique_ptr<float, decltype(&stbi_image_free)> texels(
        stbi_loadf_from_callbacks(&kCallbacks, &source, &width, &height, &channels, 3), stbi_image_free);
    if (!texels) fail("{}: not a readable Radiance file: {}", file, stbi_failure_reason());
    if (source.exhausted) fail("{}: image is truncated after {} bytes", file, bytes.size());
    if (width < 1 || height < 1) fail("{}: image has no texels: {} x {}", file, width, height);
    Image image(static_cast<uint32_t>(width), static_cast<uint32_t>(height), 3);
    std::copy_n(texels.get(), image.texels.size(), image.texels.begin());
    return image;
}

}  // namespace

Image readRadianceMap(const std::filesystem::path& path) {
    const std::string bytes = readTextFile(path);
    if (bytes.starts_with("#?RADIANCE") || bytes.starts_with("#?RGBE")) return readHdr(bytes, path.string());
    if (bytes.starts_with("\x76\x2f\x31\x01")) return readExr(path);
    fail("{}: neither an EXR nor a Radiance (.hdr) image", path.string());
}

}  // namespace manylight
