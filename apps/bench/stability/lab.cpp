#include "apps/bench/stability/lab.h"

#include "apps/common/interrupt.h"
#include "engine/core/error.h"
#include "engine/core/finite.h"

namespace manylight {
namespace {

void requireFinite(const Image& image) {
    for (size_t i = 0; i < image.texels.size(); ++i)
        if (!hasFiniteBits(image.texels[i]))
            fail("the picture has a value that is not finite, at pixel ({}, {})", i / 3 % image.width,
                 i / 3 / image.width);
}

}  // namespace

Image StabilityLab::render(const Scene& scene, const RenderSettings& settings, uint32_t frames) {
    Renderer renderer(device_, scene, settings, &pipelines_);
    return render(renderer, settings, frames);
}

Image StabilityLab::render(Renderer& renderer, const RenderSettings& settings, uint32_t frames) {
    renderer.restart(settings);
    for (uint32_t i = 0; i < frames; ++i) {
        if (isInterrupted()) fail("interrupted");
        renderer.renderFrame();
    }
    Image image = renderer.radiance();
    requireFinite(image);
    return image;
}

std::vector<double> StabilityLab::means(Renderer& renderer, RenderSettings settings, uint32_t seeds, uint32_t frames) {
    std::vector<double> means;
    for (settings.seed = 0; settings.seed < seeds; ++settings.seed)
        means.push_back(meanOf(render(renderer, settings, frames)));
    return means;
}

std::vector<double> StabilityLab::means(const Scene& scene, const RenderSettings& settings, uint32_t seeds,
                                        uint32_t frames) {
    Renderer renderer(device_, scene, settings, &pipelines_);
    return means(renderer, settings, seeds, frames);
}

double meanOf(const Image& image) {
    double sum = 0.0;
    for (const float value : image.texels) sum += double{value};
    return sum / static_cast<double>(image.texels.size());
}

RenderSettings stabilitySettings(uint32_t width, uint32_t height) {
    RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.vplCount = 256;
    settings.bounceCount = -1;
    settings.gbuffer = GBufferBy::Raster;  // not as the number of triangles suggests, which cases change
    return settings;
}

RenderSettings withTechnique(RenderSettings settings, Technique technique) {
    settings.technique = technique;
    return settings;
}

RenderSettings withClamp(RenderSettings settings, ClampMode clamp) {
    settings.clamp = clamp;
    return settings;
}

std::string errorOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

Finding isRefused(std::string what, const std::string& part, const std::function<void()>& action) {
    const std::string message = errorOf(action);
    return holds(std::move(what), fmt::format("an error that names '{}'", part), message.empty() ? "no error" : message,
                 message.find(part) != std::string::npos);
}

}  // namespace manylight
