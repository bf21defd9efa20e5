#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/image/byte_source.h"
#include "engine/image/image_faults.h"
#include "engine/image/image_io.h"

#include <cstdlib>

// Static, because other libraries of the system carry the same symbols.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_ONLY_BMP
#define STBI_MAX_DIMENSIONS 16384
// Zeroed memory: a JPEG may use tables that it never defines, and the decoder would look up what was there before.
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC(pointer, size) std::realloc(pointer, size)
#define STBI_FREE(pointer) std::free(pointer)
#include <stb_image.h>

#include <memory>

namespace manylight {

namespace {

// A byte of a PNG inflates to 1032 at most, a byte of rows has 8 texels at most; the other formats stay far below.
constexpr uint64_t kMostTexelsPerByte = uint64_t{8} * 1032;

constexpr stbi_io_callbacks kCallbacks = byteSourceCallbacks<stbi_io_callbacks>();

/// A header may claim any size: no image of `size` bytes has so many texels as not to be worth the memory for them.
void checkClaimedSize(const uint8_t* bytes, size_t size, const std::string& nameForErrors) {
    ByteSource source{bytes, size};
    int width = 0;
    int height = 0;
    int channels = 0;
    if (!stbi_info_from_callbacks(&kCallbacks, &source, &width, &height, &channels)) return;
    if (static_cast<uint64_t>(width) * static_cast<uint64_t>(height) > kMostTexelsPerByte * size)
        fail("{}: image is truncated or damaged: {} bytes cannot hold {} x {} texels", nameForErrors, size, width,
             height);
}

}  // namespace

EncodedImage readImage8(const std::filesystem::path& path) {
    const std::string bytes = readTextFile(path);
    return readImage8(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size(), path.string());
}

EncodedImage readImage8(const uint8_t* bytes, size_t size, const std::string& nameForErrors) {
    if (size == 0) fail("{}: image is empty, expected PNG, JPEG, TGA or BMP", nameForErrors);
    if (const char* const fault = imageFault({bytes, size}))
        fail("{}: image is truncated or damaged: {}", nameForErrors, fault);
    checkClaimedSize(bytes, size, nameForErrors);
    ByteSource source{bytes, size};
    int width = 0;
    int height = 0;
    int storedChannels = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> texels(
        stbi_load_from_callbacks(&kCallbacks, &source, &width, &height, &storedChannels, 4), stbi_image_free);
    if (!texels)
        fail("{}: not a readable image ({}), expected PNG, JPEG, TGA or BMP", nameForErrors, stbi_failure_reason());
    if (source.exhausted) fail("{}: image is truncated after {} bytes", nameForErrors, size);

    if (width < 1 || height < 1) fail("{}: image has no texels: {} x {}", nameForErrors, width, height);

    EncodedImage image{static_cast<uint32_t>(width), static_cast<uint32_t>(height), {}};
    image.rgba.assign(texels.get(), texels.get() + size_t{4} * image.width * image.height);
    return image;
}

}  // namespace manylight
