// G-buffer channels as EXR layers, in the scene's own units.
#pragma once

#include "engine/image/image_io.h"
#include "engine/techniques/renderer.h"

namespace manylight {

/// Renders the G-buffer once more (restarting the renderer) and returns the layers named: normal, albedo, depth,
/// position, material. Throws Error (usage) for another name.
std::vector<ExrLayer> captureAovs(Renderer& renderer, const Scene& scene, const std::vector<std::string>& names);

}  // namespace manylight
