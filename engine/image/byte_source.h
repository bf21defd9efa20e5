// What stb_image reads from.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace manylight {

/// Bytes in memory that remember whether the decoder asked for more than there are: stb_image itself fills what
/// is missing from a truncated JPEG, TGA or BMP with zeros and reports success.
struct ByteSource {
    const uint8_t* next;
    size_t left;
    const char* refillBuffer = nullptr;  // where the first read goes: reads ahead into it may come up short
    bool exhausted = false;

    int read(char* target, int size) {
        if (!refillBuffer) refillBuffer = target;
        const size_t wanted = static_cast<size_t>(size);
        const size_t count = std::min(wanted, left);
        if (count == 0 || (count < wanted && target != refillBuffer)) exhausted = true;
        std::memcpy(target, next, count);
        skip(count);
        return static_cast<int>(count);
    }
    void skip(size_t count) {
        if (count > left) exhausted = true;
        count = std::min(count, left);
        next += count;
        left -= count;
    }
};

/// `Callbacks` is stbi_io_callbacks, which every file that holds a decoder of its own has its own of.
template <typename Callbacks>
constexpr Callbacks byteSourceCallbacks() {
    return {[](void* source, char* target, int size) { return static_cast<ByteSource*>(source)->read(target, size); },
            [](void* source, int count) {
                static_cast<ByteSource*>(source)->skip(static_cast<size_t>(std::max(count, 0)));
            },
            [](void* source) { return static_cast<int>(static_cast<ByteSource*>(source)->left == 0); }};
}

}  // namespace manylight
