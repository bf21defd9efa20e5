// The G-buffer on the host, decoded: for AOVs and for tests.
#pragma once

#include "engine/techniques/renderer.h"

#include <vector>

namespace manylight {

struct GBufferTexel {
    bool isSurface = false;
    uint32_t triangle = 0;  // in the BVH's leaf order
    uint32_t material = 0;
    glm::vec3 position{0.0f};  // normalised frame
    glm::vec3 normal{0.0f};
    glm::vec3 albedo{0.0f};  // of the diffuse base, plus the reflectance at normal incidence of what is above it
};

/// Row by row from the top; settings().width * settings().height texels.
struct GBufferImage {
    std::vector<GBufferTexel> texels;
};

/// Renders the G-buffer alone, through pixel centres; the renderer's frames so far are forgotten.
GBufferImage captureGBuffer(Renderer& renderer, const Scene& scene);

}  // namespace manylight
