#include "engine/techniques/lit_area.h"

#include "shaders/shared/constants.h"

#include <algorithm>
#include <vector>

namespace manylight {
namespace {

constexpr size_t kNeighbours = 16;

/// Square of the distance to the neighbour of that number, coincident ones included.
double squaredReach(const std::vector<glm::dvec3>& points, size_t of, std::vector<double>& scratch) {
    scratch.clear();
    for (size_t i = 0; i < points.size(); ++i) {
        if (i == of) continue;
        const glm::dvec3 away = points[i] - points[of];
        scratch.push_back(glm::dot(away, away));
    }
    const auto last = scratch.begin() + kNeighbours - 1;
    std::nth_element(scratch.begin(), last, scratch.end());
    return *last;
}

}  // namespace

std::optional<double> litArea(std::span<const shared::LightData> vpls) {
    std::vector<glm::dvec3> points;
    for (const shared::LightData& vpl : vpls)
        if (vpl.intensity > 0.0f) points.emplace_back(vpl.position);
    if (points.size() <= 2 * kNeighbours) return std::nullopt;

    std::vector<double> reaches;
    std::vector<double> scratch;
    for (size_t i = 0; i < points.size(); ++i) reaches.push_back(squaredReach(points, i, scratch));
    const auto middle = reaches.begin() + static_cast<std::ptrdiff_t>(reaches.size() / 2);
    std::nth_element(reaches.begin(), middle, reaches.end());
    if (*middle <= 0.0) return std::nullopt;

    // The k-th of n points with density n / A lies in a disc of area pi r^2 = Gamma(k) A / n, whose median is k - 1/3.
    const double others = static_cast<double>(points.size() - 1);
    return double{shared::kPi} * *middle * others / (double{kNeighbours} - 1.0 / 3.0);
}

}  // namespace manylight
