#include "engine/metrics/pixel_use.h"

#include "engine/core/check.h"
#include "engine/core/finite.h"

namespace manylight {

bool isFinitePixel(const Image& image, size_t pixel) {
    const float* texel = &image.texels[pixel * image.channels];
    for (uint32_t c = 0; c < image.channels; ++c)
        if (!hasFiniteBits(texel[c])) return false;
    return true;
}

PixelUse pixelUse(const Image& test, const Image& reference, const Mask* mask) {
    MANYLIGHT_CHECK(test.width == reference.width, "pictures to compare");
    MANYLIGHT_CHECK(test.height == reference.height, "pictures to compare");
    MANYLIGHT_CHECK(test.channels == reference.channels, "pictures to compare");
    const size_t pixelCount = size_t{test.width} * test.height;
    if (mask) {
        MANYLIGHT_CHECK(mask->width == test.width, "mask");
        MANYLIGHT_CHECK(mask->uses.size() == pixelCount, "mask");
    }

    PixelUse use;
    use.uses.resize(pixelCount);
    for (size_t i = 0; i < pixelCount; ++i) {
        if (mask && !mask->uses[i]) {
            ++use.maskedOut;
            continue;
        }
        const bool testIsFinite = isFinitePixel(test, i);
        const bool referenceIsFinite = isFinitePixel(reference, i);
        use.nonFiniteTest += !testIsFinite;
        use.nonFiniteReference += !referenceIsFinite;
        use.nonFinite += !testIsFinite || !referenceIsFinite;
        use.uses[i] = testIsFinite && referenceIsFinite;
        use.compared += use.uses[i];
    }
    return use;
}

}  // namespace manylight
