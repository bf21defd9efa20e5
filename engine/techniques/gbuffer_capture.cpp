#include "engine/techniques/gbuffer_capture.h"

#include "engine/core/check.h"

#include <bit>
#include <cmath>
#include <cstring>

namespace manylight {
namespace {

constexpr double kAlbedoSteps = (1 << 21) - 1;

glm::vec3 unpackAlbedo(uint32_t low, uint32_t high) {
    const uint64_t bits = uint64_t{high} << 32 | low;
    const auto channel = [&](int i) {
        return static_cast<float>(static_cast<double>(bits >> (21 * i) & 0x1fffff) / kAlbedoSteps);
    };
    return {channel(0), channel(1), channel(2)};
}

glm::vec3 unpackNormal(float x, float y) {
    const float z = 1.0f - std::abs(x) - std::abs(y);
    const float fold = std::max(-z, 0.0f);
    return glm::normalize(glm::vec3(x - std::copysign(fold, x), y - std::copysign(fold, y), z));
}

}  // namespace

GBufferImage captureGBuffer(Renderer& renderer, const Scene& scene) {
    RenderSettings settings = renderer.settings();
    settings.show = Show::Normal;
    settings.jitter = false;
    renderer.restart(settings);
    renderer.executor().dumpAfter("gbuffer");
    const Execution execution = renderer.renderFrame();
    renderer.executor().dumpAfter("");
    MANYLIGHT_CHECK(execution.dumped.size() == 3u, "images of pass gbuffer");

    const TriangleNumbers& numbers = renderer.gpuScene().numbers;
    GBufferImage image;
    image.texels.resize(size_t{settings.width} * settings.height);
    for (size_t pixel = 0; pixel < image.texels.size(); ++pixel) {
        uint32_t position[4];
        uint32_t shading[4];
        std::memcpy(position, execution.dumped[0].bytes.data() + pixel * sizeof(position), sizeof(position));
        std::memcpy(shading, execution.dumped[1].bytes.data() + pixel * sizeof(shading), sizeof(shading));
        if (position[3] == 0) continue;
        GBufferTexel& texel = image.texels[pixel];
        texel.isSurface = true;
        texel.triangle = position[3] - 1;
        texel.material = scene.triangles[numbers.sceneTriangle(texel.triangle)].material;
        texel.position = {std::bit_cast<float>(position[0]), std::bit_cast<float>(position[1]),
                          std::bit_cast<float>(position[2])};
        texel.normal = unpackNormal(std::bit_cast<float>(shading[0]), std::bit_cast<float>(shading[1]));
        texel.albedo = unpackAlbedo(shading[2], shading[3]);
        if (!renderer.plan().glossy) continue;
        float gloss[4];
        std::memcpy(gloss, execution.dumped[2].bytes.data() + pixel * sizeof(gloss), sizeof(gloss));
        texel.albedo += glm::vec3(gloss[0], gloss[1], gloss[2]);
    }
    return image;
}

}  // namespace manylight
