// G-buffer channels as EXR layers, in the scene's own units.
#pragma once

#include "engine/image/image_io.h"
#include "engine/techniques/renderer.h"

namespace manylight {

/// Throws Error (usage) for a name that is no AOV.
void requireKnownAovs(const std::vector<std::string>& names);

/// Renders the G-buffer once more (restarting the renderer) and returns the layers named: normal, albedo, depth,
/// position, material.
std::vector<ExrLayer> captureAovs(Renderer& renderer, const Scene& scene, const std::vector<std::string>& names);

}  // namespace manylight
