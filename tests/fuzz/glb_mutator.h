// Changes to a GLB that keep its lengths right: without them hardly any input gets past the header.
#pragma once

#include <cstddef>
#include <cstdint>

namespace manylight::fuzz {

/// As libFuzzer defines it: changes `size` bytes in place, to at most `mostBytes`, and returns the new size.
using Mutate = size_t (*)(uint8_t* data, size_t size, size_t mostBytes);

/// By `seed`: mutates the JSON chunk or the binary chunk and packs both again, or (one time in eight, and where the
/// input is no GLB of two chunks at most) all the bytes as they are.
size_t mutateGlb(uint8_t* data, size_t size, size_t mostBytes, unsigned int seed, Mutate mutate);

}  // namespace manylight::fuzz
