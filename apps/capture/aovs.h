// What else is known of a picture's pixels, as EXR layers, in the scene's own units.
#pragma once

#include "engine/image/image_io.h"
#include "engine/techniques/renderer.h"

namespace manylight {

/// Throws Error (usage) for a name that is no AOV.
void requireKnownAovs(const std::vector<std::string>& names);

/// Before the first frame: has the renderer keep what some AOVs need.
void prepareAovs(Renderer& renderer, const std::vector<std::string>& names);

/// The layers named. variance (of the mean, per channel) and cut-off (radiance that the bound on the geometry term
/// took) are of the frames rendered; for normal, albedo, depth, position and material the G-buffer is rendered once
/// more, which restarts the renderer.
std::vector<ExrLayer> captureAovs(Renderer& renderer, const Scene& scene, const std::vector<std::string>& names);

}  // namespace manylight
