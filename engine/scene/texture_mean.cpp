#include "engine/scene/texture_mean.h"

#include "engine/image/srgb.h"

#include <array>

namespace manylight {

glm::dvec3 meanOfTexture(const Texture& texture) {
    std::array<std::array<uint64_t, 256>, 3> counts{};
    for (size_t i = 0; i + 3 < texture.rgba.size(); i += 4)
        for (size_t channel = 0; channel < 3; ++channel) ++counts[channel][texture.rgba[i + channel]];
    if (texture.rgba.empty()) return glm::dvec3(1.0);
    glm::dvec3 sum(0.0);
    for (size_t byte = 0; byte < 256; ++byte) {
        const double value{decodeSrgb(static_cast<float>(byte) / 255.0f)};
        for (int channel = 0; channel < 3; ++channel)
            sum[channel] += static_cast<double>(counts[static_cast<size_t>(channel)][byte]) * value;
    }
    return sum * 4.0 / static_cast<double>(texture.rgba.size());
}

}  // namespace manylight
