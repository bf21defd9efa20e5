// From pictures and panels to the window: picture, panel and present passes, two frames in flight.
#pragma once

#include "apps/view/panel_pass.h"
#include "apps/view/swapchain.h"
#include "apps/view_model/recent_values.h"
#include "engine/graph/execute.h"

#include <array>
#include <optional>

namespace manylight {

/// What the window shows. `other` lies beyond the divider, a share of the width.
struct Shown {
    PhysicalImage* picture = nullptr;
    PhysicalImage* other = nullptr;
    float divider = 1.0f;
};

class Presenter {
  public:
    Presenter(gpu::Device& device, const Window& window, PresentMode mode);
    ~Presenter();
    Presenter(const Presenter&) = delete;
    Presenter& operator=(const Presenter&) = delete;

    /// Draws and presents; does nothing while the window has no pixels.
    void present(const Shown& shown, const ImDrawData& panels);
    /// After the font has become another.
    void renewAtlas();
    /// Waits until nothing that was shown is read any more: before pictures are remade.
    void finish();
    /// The window's content as it was presented last, RGBA bytes. At least one frame must have been.
    struct Screenshot {
        glm::uvec2 size{0};
        std::vector<uint8_t> rgba;
    };
    Screenshot screenshot();

    gpu::PipelineLibrary& pipelines() { return pipelines_; }
    const Swapchain& swapchain() const { return swapchain_; }
    /// GPU times of the passes of the last frame that is done.
    const std::vector<PassTime>& passTimes() const { return passTimes_; }
    uint64_t presentedFrames() const { return presentedFrames_; }
    /// GPU milliseconds of the panels in the frames that are done; 0 where they were not drawn.
    const RecentValues& panelMilliseconds() const { return panelMilliseconds_; }
    /// How often the panels had to be drawn.
    uint64_t drawnPanels() const { return drawnPanelCount_; }
    /// Milliseconds that the last frame took to copy what the panels draw.
    double uploadMilliseconds() const { return uploadMilliseconds_; }

  private:
    bool follow(glm::uvec2 size);
    /// Without `panels` they look as they did.
    FrameGraph declare(const Shown& shown, PanelFrame* panels, PhysicalImage& target);

    struct Flight;
    void finish(Flight& flight);

    struct Flight {
        std::unique_ptr<GraphExecutor> executor;
        PanelFrame panels;
        VkSemaphore available = VK_NULL_HANDLE;
    };

    gpu::Device& device_;
    const Window& window_;
    gpu::PipelineLibrary pipelines_;
    Swapchain swapchain_;
    PanelAtlas atlas_;
    PhysicalImage canvas_;
    PhysicalImage panelLayer_;             // drawn anew only if it changes
    std::optional<uint64_t> drawnPanels_;  // fingerprint of what is there
    std::vector<PixelRect> panelRects_;    // where it is not empty
    PhysicalImage nothing_;                // one pixel, for the other picture where there is none
    std::array<Flight, 2> flights_;
    size_t next_ = 0;
    bool isStale_ = false;  // the swapchain does not fit the window any more
    std::vector<PassTime> passTimes_;
    RecentValues panelMilliseconds_;
    uint64_t presentedFrames_ = 0;
    uint64_t drawnPanelCount_ = 0;
    double uploadMilliseconds_ = 0.0;
};

}  // namespace manylight
