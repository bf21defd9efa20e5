// What the cases of the stability suite work with: one device, and short ways to render.
#pragma once

#include "apps/bench/stability/findings.h"
#include "engine/techniques/renderer.h"

#include <functional>

namespace manylight {

class StabilityLab {
  public:
    explicit StabilityLab(gpu::Device& device) : device_(device), pipelines_(device) {}

    gpu::Device& device() { return device_; }
    /// What the renderers of all cases share.
    gpu::PipelineLibrary* pipelines() { return &pipelines_; }

    /// Mean radiance of `frames` frames. Throws Error if a value of it is not finite, told by its bits.
    Image render(const Scene& scene, const RenderSettings& settings, uint32_t frames = 1);
    /// As above, of a renderer that was made before; it is started anew.
    Image render(Renderer& renderer, const RenderSettings& settings, uint32_t frames = 1);
    /// The pictures' means with seeds 0, 1, ..., `seeds` - 1.
    std::vector<double> means(Renderer& renderer, RenderSettings settings, uint32_t seeds = 16, uint32_t frames = 1);
    std::vector<double> means(const Scene& scene, const RenderSettings& settings, uint32_t seeds = 16,
                              uint32_t frames = 1);

  private:
    gpu::Device& device_;
    gpu::PipelineLibrary pipelines_;
};

double meanOf(const Image& image);

/// 16 x 16 pixels with shadows, roulette and no limit on the depth; 256 paths and as many VPLs.
RenderSettings stabilitySettings(uint32_t width = 16, uint32_t height = 16);
RenderSettings withTechnique(RenderSettings settings, Technique technique);
RenderSettings withClamp(RenderSettings settings, ClampMode clamp);

/// What `action` throws as Error, or nothing.
std::string errorOf(const std::function<void()>& action);
/// An Error whose message contains `part`.
Finding isRefused(std::string what, const std::string& part, const std::function<void()>& action);

}  // namespace manylight
