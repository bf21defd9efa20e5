#include "engine/scene/normalise_parts.h"

#include <algorithm>
#include <cmath>

namespace manylight {

void convertEnvironment(const RawScene& raw, Scene& scene) {
    if (!raw.environment) return;
    const RawEnvironment& source = *raw.environment;
    EnvironmentMap map{.name = source.name,
                       .radiance = source.radiance,
                       .turn = static_cast<float>(source.turn - std::floor(source.turn))};
    std::vector<float>& texels = map.radiance.texels;
    uint64_t repaired = 0;
    for (size_t i = 0; i < texels.size(); i += 3) {
        const glm::vec3 radiance(source.scale * glm::dvec3(texels[i], texels[i + 1], texels[i + 2]));
        bool isGood = true;
        for (int channel = 0; channel < 3; ++channel)
            isGood = isGood && std::isfinite(radiance[channel]) && radiance[channel] >= 0.0f;
        for (int channel = 0; channel < 3; ++channel)
            texels[i + static_cast<size_t>(channel)] = isGood ? radiance[channel] : 0.0f;
        repaired += isGood ? 0 : 1;
    }
    scene.warnings.add("texels of environment maps set to zero: negative or not a number", source.name, repaired);
    if (std::all_of(texels.begin(), texels.end(), [](float value) { return value == 0.0f; })) {
        scene.warnings.add("environment maps left out: black", source.name);
        return;
    }
    scene.environment = std::move(map);
}

}  // namespace manylight
