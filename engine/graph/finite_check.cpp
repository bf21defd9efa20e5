#include "engine/graph/finite_check.h"

#include "engine/core/finite.h"

#include <cstring>

namespace manylight {
namespace {

bool isFloat(VkFormat format) { return format == VK_FORMAT_R32G32B32A32_SFLOAT || format == VK_FORMAT_D32_SFLOAT; }

}  // namespace

std::optional<NonFinite> findNonFinite(const std::vector<DumpedImage>& dumped) {
    for (const DumpedImage& image : dumped) {
        if (!isFloat(image.format)) continue;
        const size_t components = image.format == VK_FORMAT_D32_SFLOAT ? 1 : 4;
        std::vector<uint32_t> bits(size_t{image.width} * image.height * components);
        std::memcpy(bits.data(), image.bytes.data(), bits.size() * sizeof(uint32_t));
        NonFinite found{image.pass, image.resource};
        for (size_t texel = 0; texel < bits.size() / components; ++texel) {
            bool isFinite = true;
            for (size_t c = 0; c < components; ++c) isFinite = isFinite && areFiniteBits(bits[texel * components + c]);
            if (isFinite) continue;
            if (found.texels++ > 0) continue;
            found.x = static_cast<uint32_t>(texel % image.width);
            found.y = static_cast<uint32_t>(texel / image.width);
        }
        if (found.texels > 0) return found;
    }
    return std::nullopt;
}

}  // namespace manylight
