#include "engine/techniques/accumulator.h"

#include "engine/core/check.h"

#include <cstring>

namespace manylight {
namespace {

PhysicalImage makeImage(gpu::Device& device, const std::string& name, uint32_t width, uint32_t height) {
    constexpr VkImageUsageFlags kUsage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    PhysicalImage image;
    image.texture = gpu::Texture(device, name, {VK_FORMAT_R32G32B32A32_SFLOAT, width, height, kUsage});
    return image;
}

}  // namespace

Image scaledRgb(gpu::Device& device, PhysicalImage& source, double scale) {
    const std::vector<std::byte> bytes = readPhysical(device, source);
    Image image(source.texture.info().width, source.texture.info().height, 3);
    for (size_t pixel = 0; pixel < size_t{image.width} * image.height; ++pixel) {
        float rgba[4];
        std::memcpy(rgba, bytes.data() + pixel * sizeof(rgba), sizeof(rgba));
        for (size_t c = 0; c < 3; ++c) image.texels[pixel * 3 + c] = static_cast<float>(double{rgba[c]} * scale);
    }
    return image;
}

Accumulator::Accumulator(gpu::Device& device, const std::string& name, uint32_t width, uint32_t height,
                         bool keepsVariance)
    : sum_(makeImage(device, name + " sum", width, height)),
      roundingError_(makeImage(device, name + " rounding error", width, height)),
      name_(name),
      width_(width),
      height_(height) {
    if (keepsVariance) squaredDeviations_ = makeImage(device, name + " squared deviations", width, height);
}

ImageHandle Accumulator::add(FrameGraph& graph, const SceneHandles& scene, ImageHandle radiance, uint32_t frameCount) {
    const bool isFirst = frameCount == 0;
    RunningSum running{importPhysical(graph, name_ + " sum", sum_),
                       importPhysical(graph, name_ + " rounding error", roundingError_)};
    if (keepsVariance() && !isFirst) {
        const ImageHandle deviations = importPhysical(graph, name_ + " squared deviations", squaredDeviations_);
        graph.keep(addVariance(graph, scene, radiance, running.sum, deviations, frameCount == 1, width_, height_));
    }
    running = addAccumulate(graph, scene, radiance, running, isFirst, width_, height_);
    graph.keep(running.sum);
    graph.keep(running.roundingError);
    return running.sum;
}

Image Accumulator::mean(gpu::Device& device, uint32_t frameCount) {
    MANYLIGHT_CHECK(frameCount > 0u, "{}", name_);
    return scaledRgb(device, sum_, 1.0 / frameCount);
}

Image Accumulator::varianceOfMean(gpu::Device& device, uint32_t frameCount) {
    MANYLIGHT_CHECK(keepsVariance(), "{}", name_);
    MANYLIGHT_CHECK(frameCount > 1u, "{}", name_);
    return scaledRgb(device, squaredDeviations_, 1.0 / (frameCount * (frameCount - 1.0)));
}

}  // namespace manylight
