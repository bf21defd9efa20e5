#include "apps/view/comparison.h"

#include "engine/metrics/false_colour.h"
#include "engine/metrics/flip.h"
#include "engine/metrics/luminance.h"

#include <cmath>
#include <span>

namespace manylight {
namespace {

constexpr double kFlipPause = 5.0;  // times as long as it took

}  // namespace

void Comparison::update(Renderer& side, const Image& reference, bool isLast) {
    const Image test = side.radiance();
    if (test.width != reference.width || test.height != reference.height) {
        report_.reset();
        fail("the reference has {}x{} pixels and the picture {}x{}: they must have the same", reference.width,
             reference.height, test.width, test.height);
    }
    report_ = compareImages(test, reference);
    paint(test, reference, report_->meanLuminanceReference);
    if (isLast) flipAt_ = {};
    measureFlip(test, reference);
}

void Comparison::clear() {
    report_.reset();
    flip_.reset();
    flipAt_ = {};
}

void Comparison::measureFlip(const Image& test, const Image& reference) {
    using Clock = std::chrono::steady_clock;
    const auto secondsSince = [](Clock::time_point start) {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    if (secondsSince(flipAt_) < kFlipPause * flipSeconds_) return;
    const Clock::time_point start = Clock::now();
    const std::optional<FlipResult> result = hdrFlip(test, reference);
    flip_ = result ? std::optional(result->mean) : std::nullopt;
    flipAt_ = Clock::now();
    flipSeconds_ = secondsSince(start);
}

void Comparison::paint(const Image& test, const Image& reference, double meanLuminance) {
    const size_t count = size_t{test.width} * test.height;
    const double scale = meanLuminance > 0.0 ? 1.0 / (kFullColour * meanLuminance) : 0.0;
    std::vector<uint8_t> rgba(count * 4, 255);
    for (size_t pixel = 0; pixel < count; ++pixel) {
        const auto at = [&](const Image& image) { return luminanceOf(&image.texels[pixel * 3]); };
        const glm::vec3 colour = blueGreyRed(static_cast<float>(scale * (at(test) - at(reference))));
        for (int c = 0; c < 3; ++c)
            rgba[pixel * 4 + static_cast<size_t>(c)] = static_cast<uint8_t>(std::lround(255.0f * colour[c]));
    }
    const bool fits = picture_.texture.exists() && picture_.texture.info().width == test.width &&
                      picture_.texture.info().height == test.height;
    if (!fits) {
        constexpr VkImageUsageFlags kUsage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
        picture_ = {};
        picture_.texture =
            gpu::Texture(device_, "difference", {VK_FORMAT_R8G8B8A8_UNORM, test.width, test.height, kUsage});
    }
    writePhysical(device_, picture_, std::as_bytes(std::span(rgba)));
}

}  // namespace manylight
