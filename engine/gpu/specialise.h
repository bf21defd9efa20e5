// Shaders without what their specialisation constants leave out.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace manylight::gpu {

/// Words by constant_id; of booleans 0 and 1, of floats their bits.
using ConstantValues = std::map<uint32_t, uint32_t>;

/// The SPIR-V module with `values` for its specialisation constants, and for those not named what the shader says,
/// without the branches that these close and the functions that only they called. A driver would leave them out too,
/// but only after it has put every function in the place of every call: a shader that traces rays at three places has
/// them for instances and for translucent surfaces at all of them. Throws BugError for what is no module.
std::vector<uint32_t> specialised(std::span<const uint32_t> words, const ConstantValues& values);

}  // namespace manylight::gpu
