#include "apps/view/presenter.h"

#include "engine/core/check.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/window.h"

#include <imgui.h>

#include <chrono>
#include <cstring>

namespace manylight {
namespace {

constexpr uint32_t kFullScreen = 3;    // vertices of one large triangle
constexpr uint32_t kTwoTriangles = 6;  // vertices of a rectangle

glm::uvec2 sizeOf(const PhysicalImage& image) { return {image.texture.info().width, image.texture.info().height}; }

}  // namespace

Presenter::Presenter(gpu::Device& device, const Window& window, PresentMode mode)
    : device_(device), window_(window), pipelines_(device), swapchain_(device, window, mode), atlas_(device) {
    constexpr VkImageUsageFlags kUsage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    nothing_.texture = gpu::Texture(device, "no other picture", {VK_FORMAT_R8G8B8A8_UNORM, 1, 1, kUsage});
    writePhysical(device, nothing_, std::array<std::byte, 4>{});
    for (Flight& flight : flights_) {
        flight.executor = std::make_unique<GraphExecutor>(device, pipelines_);
        VkSemaphoreCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
        gpu::check(vkCreateSemaphore(device.handle(), &info, nullptr, &flight.available), "making a semaphore");
    }
}

Presenter::~Presenter() {
    vkDeviceWaitIdle(device_.handle());
    for (const Flight& flight : flights_) vkDestroySemaphore(device_.handle(), flight.available, nullptr);
}

void Presenter::renewAtlas() {
    finish();
    atlas_ = PanelAtlas(device_);
    drawnPanels_.reset();
}

void Presenter::finish() {
    for (size_t i = 0; i < flights_.size(); ++i) finish(flights_[(next_ + i) % flights_.size()]);
}

void Presenter::finish(Flight& flight) {
    const Execution done = flight.executor->finish();
    if (done.passTimes.empty()) return;
    passTimes_ = done.passTimes;
    double panels = 0.0;
    for (const PassTime& pass : passTimes_)
        if (pass.pass.starts_with(kPanelPass)) panels += pass.milliseconds;
    panelMilliseconds_.add(panels);
}

bool Presenter::follow(glm::uvec2 size) {
    if (size.x == 0 || size.y == 0) return false;
    if (isStale_ || swapchain_.size() != size) {
        finish();
        vkQueueWaitIdle(device_.queue());  // presentations hold semaphores too
        if (!swapchain_.recreate()) return false;
        isStale_ = false;
    }
    if (canvas_.texture.exists() && sizeOf(canvas_) == swapchain_.size()) return true;
    finish();
    constexpr VkImageUsageFlags kUsage =
        VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    const gpu::TextureInfo info{VK_FORMAT_R8G8B8A8_UNORM, swapchain_.size().x, swapchain_.size().y, kUsage};
    canvas_ = {};
    canvas_.texture = gpu::Texture(device_, "canvas", info);
    panelLayer_ = {};
    panelLayer_.texture = gpu::Texture(device_, "panels", info);
    drawnPanels_.reset();
    return true;
}

FrameGraph Presenter::declare(const Shown& shown, PanelFrame* panels, PhysicalImage& target) {
    const glm::uvec2 size = swapchain_.size();
    PhysicalImage& picture = *shown.picture;
    const bool hasOther = shown.other != nullptr && shown.other != shown.picture;
    FrameGraph graph;
    ImageHandle canvas = importPhysical(graph, "canvas", canvas_);
    ImageHandle layer = importPhysical(graph, "panels", panelLayer_);
    if (panels != nullptr) layer = panels->add(graph, atlas_, layer, size);

    PassBuilder draw = graph.addPass("window_picture");
    const ImageHandle left = importPhysical(graph, "picture", picture);
    draw.read(left, Access::GraphicsStorageRead, shared::kBindingDisplay);
    PhysicalImage& other = hasOther ? *shown.other : nothing_;
    draw.read(importPhysical(graph, "other picture", other), Access::GraphicsStorageRead, shared::kBindingOtherDisplay);
    draw.read(layer, Access::GraphicsStorageRead, shared::kBindingCanvas);
    canvas = draw.write(canvas, Access::ColorWrite, VkClearValue{});
    const shared::WindowPicturePush push{
        sizeOf(picture), sizeOf(other), size,
        hasOther ? shown.divider * static_cast<float>(size.x) : static_cast<float>(size.x), glm::vec4(0.0f)};
    draw.execute([push, tiles = tileWindow(size, panelRects_)](PassContext& context) {
        for (const WindowTile& tile : tiles) {
            shared::WindowPicturePush piece = push;
            piece.tile = {tile.rect.low, tile.rect.high};
            context.draw({.vertexShader = "window_picture.vert",
                          .fragmentShader = "window_picture.frag",
                          .specialisation = {tile.hasPanels}},
                         kTwoTriangles, piece);
        }
    });

    PassBuilder present = graph.addPass("window_present");
    present.read(canvas, Access::GraphicsStorageRead, shared::kBindingCanvas);
    const ImageHandle window =
        present.write(importPhysical(graph, "window", target), Access::ColorWrite, VkClearValue{});
    present.execute([encodes = swapchain_.encodesItself()](PassContext& context) {
        context.draw({.vertexShader = "window_present.vert",
                      .fragmentShader = "window_present.frag",
                      .specialisation = {encodes}},
                     kFullScreen);
    });
    graph.addPass("window_shown").read(window, Access::Present).keep("the window system shows it");
    return graph;
}

void Presenter::present(const Shown& shown, const ImDrawData& panels) {
    if (!follow(window_.framebufferSize())) return;
    Flight& flight = flights_[next_];
    finish(flight);
    const auto start = std::chrono::steady_clock::now();
    const uint64_t fingerprint = fingerprintOf(panels);
    const bool isNew = drawnPanels_ != fingerprint;
    if (isNew) {
        flight.panels.upload(device_, panels);
        panelRects_ = panelRects(panels);
    }
    uploadMilliseconds_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    const std::optional<uint32_t> index = swapchain_.acquire(flight.available);
    isStale_ = !index.has_value();
    if (isStale_) return;
    flight.executor->submit(declare(shown, isNew ? &flight.panels : nullptr, swapchain_.image(*index)),
                            flight.available, swapchain_.isDrawn(*index));
    drawnPanels_ = fingerprint;
    drawnPanelCount_ += isNew ? 1 : 0;
    isStale_ = !swapchain_.present(*index);
    ++presentedFrames_;
    next_ = (next_ + 1) % flights_.size();
}

Presenter::Screenshot Presenter::screenshot() {
    MANYLIGHT_CHECK(canvas_.texture.exists(), "screenshot() before anything was shown");
    finish();
    const std::vector<std::byte> bytes = readPhysical(device_, canvas_);
    Screenshot shot{sizeOf(canvas_), std::vector<uint8_t>(bytes.size())};
    std::memcpy(shot.rgba.data(), bytes.data(), bytes.size());
    return shot;
}

}  // namespace manylight
