#include "engine/gpu/shader.h"

#include "engine/core/check.h"

namespace manylight::gpu {
namespace {

struct EmbeddedShader {
    std::string_view name;
    const uint32_t* words;
    size_t bytes;
};

#include "embedded_shaders.inc"

}  // namespace

std::span<const uint32_t> shaderCode(std::string_view name) {
    for (const EmbeddedShader& shader : kEmbeddedShaders)
        if (shader.name == name) return {shader.words, shader.bytes / sizeof(uint32_t)};
    throw BugError(fmt::format("no shader named {}", name));
}

std::vector<std::string_view> shaderNames() {
    std::vector<std::string_view> names;
    for (const EmbeddedShader& shader : kEmbeddedShaders) names.push_back(shader.name);
    return names;
}

std::string rayQueryVariant(std::string_view name) { return std::string(name) + "+ray_query"; }

}  // namespace manylight::gpu
