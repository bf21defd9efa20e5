// An environment map as light is drawn from it: texels, and an alias table of its bright and dark places.
#pragma once

#include "engine/scene/scene.h"
#include "shaders/shared/environment.h"

#include <vector>

namespace manylight {

/// Empty without a map.
struct EnvironmentTable {
    glm::uvec2 size{0};     // texels
    uint32_t cellSide = 1;  // of a cell, in texels; the last of a row or column may be narrower
    float turn = 0.0f;
    std::vector<glm::vec4> texels;               // radiance, row by row, constant lights included
    std::vector<shared::EnvironmentCell> cells;  // row by row
    double integral = 0.0;                       // of the mean channel over the sphere, W/m^2

    bool exists() const { return !texels.empty(); }
};

/// Cells are chosen by their radiance, mean of the channels, times their solid angle: piecewise constant importance
/// sampling (Pharr et al. 2023, sec. 12.5), by the radiance that bilinear look-ups give each texel on average, so that
/// what shines at all can be drawn. At most 2^19 cells: larger maps have several texels in one.
EnvironmentTable buildEnvironmentTable(const Scene& scene);

}  // namespace manylight
