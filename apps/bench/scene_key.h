// A name for what a converged picture depends on.
#pragma once

#include "engine/scene/scene.h"
#include "engine/techniques/settings.h"

#include <string>

namespace manylight {

/// 16 hexadecimal digits from the scene's content (geometry, materials, texels, lights, the camera) and the settings
/// that change the limit of every technique (size, bounces, lighting). `settings` as the Renderer resolved them.
std::string sceneKey(const Scene& scene, const RenderSettings& settings);

}  // namespace manylight
