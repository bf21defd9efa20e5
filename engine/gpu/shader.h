// The SPIR-V compiled at build time, by the name of its source file.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace manylight::gpu {

/// Words of e.g. "vpl_light.comp". Throws BugError for a name that shaders/passes does not have.
std::span<const uint32_t> shaderCode(std::string_view name);

/// Names of all entry points.
std::vector<std::string_view> shaderNames();

/// The name of the same entry point with its rays traced by the device: see shaders/lib/traces.glsl.
std::string rayQueryVariant(std::string_view name);

}  // namespace manylight::gpu
