#include "apps/capture/aovs.h"

#include "engine/core/check.h"
#include "engine/techniques/gbuffer_capture.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace manylight {
namespace {

/// Values of one pixel that sees a surface; `toScene` converts lengths.
struct Channel {
    const char* name;
    std::vector<std::string> suffixes;
    std::function<glm::dvec3(const GBufferTexel&, const Scene&, const Camera&)> value;
};

double sceneLength(const Scene& scene) { return std::ldexp(1.0, scene.frame.exponent); }

const std::vector<Channel>& channels() {
    static const std::vector<Channel> list = {
        {"normal",
         {"X", "Y", "Z"},
         [](const GBufferTexel& texel, const Scene&, const Camera&) { return glm::dvec3(texel.normal); }},
        {"albedo",
         {"R", "G", "B"},
         [](const GBufferTexel& texel, const Scene&, const Camera&) { return glm::dvec3(texel.albedo); }},
        {"depth",
         {"Z"},
         [](const GBufferTexel& texel, const Scene& scene, const Camera& camera) {
             return glm::dvec3(glm::dot(glm::dvec3(texel.position - camera.origin), glm::dvec3(camera.forward)) *
                               sceneLength(scene));
         }},
        {"position",
         {"X", "Y", "Z"},
         [](const GBufferTexel& texel, const Scene& scene, const Camera&) {
             return scene.frame.center + glm::dvec3(texel.position) * sceneLength(scene);
         }},
        {"material",
         {"id"},
         [](const GBufferTexel& texel, const Scene&, const Camera&) { return glm::dvec3(texel.material); }},
    };
    return list;
}

const char* const kVariance = "variance";
const char* const kCutOff = "cut-off";

bool isAccumulated(const std::string& name) { return name == kVariance || name == kCutOff; }

const Channel& channelNamed(const std::string& name) {
    std::vector<const char*> known = {kVariance, kCutOff};
    for (const Channel& channel : channels()) {
        if (name == channel.name) return channel;
        known.push_back(channel.name);
    }
    failUsage("--aov {}: expected some of {}", name, fmt::join(known, ","));
}

}  // namespace

void requireKnownAovs(const std::vector<std::string>& names) {
    for (const std::string& name : names)
        if (!isAccumulated(name)) channelNamed(name);
}

void prepareAovs(Renderer& renderer, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        if (name == kVariance) renderer.keepVariance(true);
        if (name == kCutOff) renderer.keepCutOff(true);
    }
}

std::vector<ExrLayer> captureAovs(Renderer& renderer, const Scene& scene, const std::vector<std::string>& names) {
    std::vector<ExrLayer> accumulated;
    std::vector<ExrLayer> layers;
    for (const std::string& name : names) {
        if (name == kVariance && renderer.frameCount() < 2) fail("--aov variance: only one frame was rendered");
        if (name == kVariance) accumulated.push_back({name, {"R", "G", "B"}, renderer.varianceOfMean()});
        if (name == kCutOff) accumulated.push_back({name, {"R", "G", "B"}, renderer.cutOff()});
        if (isAccumulated(name)) continue;
        const Channel& channel = channelNamed(name);
        const auto count = static_cast<uint32_t>(channel.suffixes.size());
        layers.push_back({name, channel.suffixes, Image(renderer.settings().width, renderer.settings().height, count)});
    }
    if (layers.empty()) return accumulated;

    const GBufferImage gbuffer = captureGBuffer(renderer, scene);
    const Camera& camera = scene.cameras[renderer.settings().camera];
    for (ExrLayer& layer : layers) {
        const Channel& channel = channelNamed(layer.name);
        for (size_t pixel = 0; pixel < gbuffer.texels.size(); ++pixel) {
            if (!gbuffer.texels[pixel].isSurface) continue;
            const glm::dvec3 value = channel.value(gbuffer.texels[pixel], scene, camera);
            for (uint32_t c = 0; c < layer.image.channels; ++c)
                layer.image.texels[pixel * layer.image.channels + c] = static_cast<float>(value[static_cast<int>(c)]);
        }
    }
    layers.insert(layers.begin(), accumulated.begin(), accumulated.end());
    return layers;
}

}  // namespace manylight
