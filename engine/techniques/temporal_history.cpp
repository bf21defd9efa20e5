#include "engine/techniques/temporal_history.h"

#include "engine/core/check.h"
#include "engine/techniques/accumulator.h"

#include <algorithm>

namespace manylight {
namespace {

PhysicalImage makeImage(gpu::Device& device, const std::string& name, VkFormat format, uint32_t width,
                        uint32_t height) {
    constexpr VkImageUsageFlags kUsage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    PhysicalImage image;
    image.texture = gpu::Texture(device, name, {format, width, height, kUsage});
    return image;
}

glm::uvec2 sizeOf(const PhysicalImage& image) { return {image.texture.info().width, image.texture.info().height}; }

/// Whatever the shape of the picture.
bool sameCamera(const ViewAxes& a, const ViewAxes& b) {
    return a.origin == b.origin && a.forward == b.forward && a.down == b.down;
}

}  // namespace

void TemporalHistory::makeRoom(gpu::Device& device, uint32_t width, uint32_t height) {
    if (now_.shown.texture.exists() && sizeOf(now_.shown) == glm::uvec2(width, height)) return;
    if (frames_ > 0 && !earlier_) earlier_ = std::move(now_);
    now_.shown = makeImage(device, kShown, VK_FORMAT_R32G32B32A32_SFLOAT, width, height);
    now_.guide = makeImage(device, "history guide", VK_FORMAT_R32G32B32A32_UINT, width, height);
    reprojected_ = makeImage(device, "history", VK_FORMAT_R32G32B32A32_UINT, width, height);
}

void TemporalHistory::forget() {
    earlier_.reset();
    frames_ = 0;
    isReprojected_ = false;
    sceneMoved_ = false;
}

uint32_t TemporalHistory::framesBefore(const ViewAxes& view) const {
    return sceneMoved_ || !sameCamera(view, view_) ? frames_ : 0;
}

shared::ReprojectionPush TemporalHistory::reprojection(const Images& before) const {
    const glm::vec2 size = sizeOf(now_.shown);
    const glm::vec2 sizeBefore = sizeOf(before.shown);
    return {.origin = view_.origin,
            .frames = static_cast<float>(framesOfView_),
            .right = view_.right,
            .areaShare = std::min(1.0f, sizeBefore.x * sizeBefore.y / (size.x * size.y)),
            .down = view_.down,
            .sceneMoved = sceneMoved_,
            .forward = view_.forward,
            .size = sizeBefore};
}

ImageHandle TemporalHistory::add(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan,
                                 const GBuffer& gbuffer, ImageHandle radiance, ImageHandle sum, uint32_t frameCount) {
    const auto [width, height] = std::pair(sizeOf(now_.shown).x, sizeOf(now_.shown).y);
    TemporalImages images{shown(graph), importPhysical(graph, "history guide", now_.guide)};
    ImageHandle history = importPhysical(graph, "history", reprojected_);
    const bool isFirst = frameCount == 0;
    const bool hasHistory =
        isFirst ? frames_ > 0 : isReprojected_ && static_cast<float>(frameCount) < shared::kLongestHistory;
    if (isFirst && hasHistory) {
        TemporalImages before = images;
        if (earlier_)
            before = {importPhysical(graph, "earlier shown sum", earlier_->shown),
                      importPhysical(graph, "earlier history guide", earlier_->guide)};
        history = addReprojection(graph, scene, plan, gbuffer, radiance, before, history,
                                  reprojection(earlier_ ? *earlier_ : now_), width, height);
    }
    images = addTemporal(graph, scene, plan, gbuffer, radiance, sum, history, hasHistory, images, frameCount + 1, width,
                         height);
    graph.keep(images.shown);
    graph.keep(images.guide);
    return images.shown;
}

void TemporalHistory::finishFrame(const ViewAxes& view, uint32_t frameCount) {
    if (frameCount == 1) isReprojected_ = frames_ > 0;
    earlier_.reset();
    view_ = view;
    framesOfView_ = frameCount;
    ++frames_;
    sceneMoved_ = false;
}

Image TemporalHistory::mean(gpu::Device& device, uint32_t frameCount) {
    MANYLIGHT_CHECK(frameCount > 0u, "{}", kShown);
    return scaledRgb(device, now_.shown, 1.0 / frameCount);
}

}  // namespace manylight
