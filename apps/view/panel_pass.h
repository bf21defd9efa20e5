// Dear ImGui's triangles as a pass of the frame graph.
#pragma once

#include "apps/view_model/window_tiles.h"
#include "engine/graph/pass_context.h"

struct ImDrawData;

namespace manylight {

inline constexpr const char* kPanelPass = "window_panel";

/// The font's coverage, one byte a texel. Dear ImGui must have its context.
class PanelAtlas {
  public:
    explicit PanelAtlas(gpu::Device& device);
    PhysicalBuffer& buffer() { return buffer_; }
    glm::uvec2 size() const { return size_; }

  private:
    PhysicalBuffer buffer_;
    glm::uvec2 size_{0};
};

/// The same for lists that draw the same.
uint64_t fingerprintOf(const ImDrawData& data);

/// Pixels that each list draws to, one rectangle a list: a list is a panel.
std::vector<PixelRect> panelRects(const ImDrawData& data);

/// What one frame of the panels needs on the device; one for each frame in flight.
class PanelFrame {
  public:
    /// Copies the lists; the device must be done with the last ones. They may be discarded afterwards.
    void upload(gpu::Device& device, const ImDrawData& data);
    /// Draws what was uploaded, and nothing else, to `layer`: premultiplied by its opacity.
    ImageHandle add(FrameGraph& graph, PanelAtlas& atlas, ImageHandle layer, glm::uvec2 size);

  private:
    struct Draw {
        glm::vec4 clip{0.0f};  // pixels
        uint32_t firstIndex = 0;
        uint32_t indexCount = 0;
    };
    PhysicalBuffer vertices_;
    PhysicalBuffer indices_;
    std::vector<Draw> draws_;
    glm::vec2 origin_{0.0f};
    glm::vec2 scale_{1.0f};
};

}  // namespace manylight
