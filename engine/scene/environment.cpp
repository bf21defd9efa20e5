#include "engine/scene/environment.h"

#include "engine/scene/alias_table.h"
#include "shaders/shared/constants.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

constexpr double kPi = shared::kPi;
constexpr uint32_t kMostCells = 1u << 19;  // 8 MiB

/// Mean channel of a texel's radiance as bilinear look-ups see it on average: 3/4 of its own and 1/8 of each
/// neighbour's, along both axes.
class SmoothedRadiance {
  public:
    explicit SmoothedRadiance(const EnvironmentTable& table) : table_(table) {}

    double at(uint32_t x, uint32_t y) const {
        const uint32_t above = y > 0 ? y - 1 : y;
        const uint32_t below = std::min(y + 1, table_.size.y - 1);
        return 0.125 * ring(x, above) + 0.75 * ring(x, y) + 0.125 * ring(x, below);
    }

  private:
    double ring(uint32_t x, uint32_t y) const {
        const uint32_t width = table_.size.x;
        return 0.125 * mean((x + width - 1) % width, y) + 0.75 * mean(x, y) + 0.125 * mean((x + 1) % width, y);
    }
    double mean(uint32_t x, uint32_t y) const {
        const glm::vec4& texel = table_.texels[size_t{y} * table_.size.x + x];
        return (double{texel.x} + double{texel.y} + double{texel.z}) / 3.0;
    }

    const EnvironmentTable& table_;
};

uint32_t cellsAlong(uint32_t texels, uint32_t side) { return (texels + side - 1) / side; }

glm::uvec2 cellCounts(const EnvironmentTable& table) {
    return {cellsAlong(table.size.x, table.cellSide), cellsAlong(table.size.y, table.cellSide)};
}

/// Power per area of each cell: the integral of radiance over its solid angle.
std::vector<double> cellWeights(const EnvironmentTable& table) {
    const SmoothedRadiance radiance(table);
    const glm::uvec2 counts = cellCounts(table);
    std::vector<double> weights(size_t{counts.x} * counts.y);
    for (uint32_t y = 0; y < table.size.y; ++y) {
        const double upper = std::cos(kPi * y / table.size.y);
        const double lower = std::cos(kPi * (y + 1) / table.size.y);
        const double solidAngle = 2.0 * kPi / table.size.x * (upper - lower);
        const size_t row = size_t{y / table.cellSide} * counts.x;
        for (uint32_t x = 0; x < table.size.x; ++x) weights[row + x / table.cellSide] += radiance.at(x, y) * solidAngle;
    }
    return weights;
}

void fillCells(EnvironmentTable& table) {
    const std::vector<double> weights = cellWeights(table);
    for (const double weight : weights) table.integral += weight;
    const std::vector<AliasSlot> slots = buildAliasTable(weights);
    const glm::uvec2 counts = cellCounts(table);
    // A direction is drawn evenly in uv: du dv = d omega / (2 pi^2 sin theta).
    std::vector<float> densities(weights.size());
    for (uint32_t i = 0; i < weights.size(); ++i) {
        const glm::uvec2 corner = glm::uvec2(i % counts.x, i / counts.x) * table.cellSide;
        const glm::uvec2 extent = glm::min(glm::uvec2(table.cellSide), table.size - corner);
        const double area = double(extent.x) * double(extent.y) / (double(table.size.x) * double(table.size.y));
        densities[i] = static_cast<float>(weights[i] / table.integral / (area * 2.0 * kPi * kPi));
    }
    table.cells.resize(weights.size());
    for (size_t i = 0; i < slots.size(); ++i)
        table.cells[i] = {slots[i].threshold, slots[i].alias, densities[i], densities[slots[i].alias]};
}

}  // namespace

EnvironmentTable buildEnvironmentTable(const Scene& scene) {
    EnvironmentTable table;
    if (!scene.environment) return table;
    const Image& image = scene.environment->radiance;
    glm::vec3 everywhere(0.0f);
    for (const Light& light : scene.lights)
        if (light.type == LightType::Constant) everywhere += light.emission;
    table.size = {image.width, image.height};
    table.turn = scene.environment->turn;
    while (uint64_t{cellsAlong(image.width, table.cellSide)} * cellsAlong(image.height, table.cellSide) > kMostCells)
        ++table.cellSide;
    table.texels.reserve(size_t{image.width} * image.height);
    for (size_t i = 0; i < image.texels.size(); i += 3)
        table.texels.emplace_back(everywhere + glm::vec3(image.texels[i], image.texels[i + 1], image.texels[i + 2]),
                                  1.0f);
    fillCells(table);
    return table;
}

}  // namespace manylight
