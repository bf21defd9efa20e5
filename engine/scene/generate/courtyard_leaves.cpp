// Leaves: small two-sided quads that make the bushes and trees, and bring the scene to its triangle count.
#include "engine/scene/generate/courtyard_parts.h"

namespace manylight::courtyard {

namespace {

enum Part : uint64_t { kLeafPart = 300 };

/// A rhombus twice as long as it is wide, lying roughly in the surface of the crown.
void addLeaf(const Site& site, const LeafCloud& cloud, double halfWidth, SceneRandom& random) {
    const glm::dvec3 out = uniformDirection(random);
    const double shell = 1.0 - 0.45 * random.unit() * random.unit();
    const glm::dvec3 center = cloud.center + cloud.radii * out * shell;
    const glm::dvec3 normal = glm::normalize(out + 0.9 * uniformDirection(random) * random.unit());
    const glm::dvec3 helper = std::abs(normal.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(helper, normal));
    const glm::dvec3 v = glm::cross(normal, u);
    const double turn = uniformAngle(random);
    const glm::dvec3 width = halfWidth * (std::cos(turn) * u + std::sin(turn) * v);
    const glm::dvec3 length = 2.0 * halfWidth * (std::cos(turn) * v - std::sin(turn) * u);
    const bool isFlower = random.unit() < cloud.flowerShare;
    const uint32_t leaf = site.palette.leaf[random.below(4)];
    addQuad(site.mesh, isFlower ? site.palette.flower : leaf,
            {center - length, center + width, center + length, center - width});
}

}  // namespace

void addLeaves(const Site& site, uint64_t count) {
    SceneRandom random = site.random(kLeafPart);
    double totalArea = 0.0;
    for (const LeafCloud& cloud : site.leafClouds) totalArea += cloud.leafArea;

    // Many leaves are small ones: the foliage is as dense whatever their number. A rhombus covers 4 halfWidth^2.
    const double halfWidth =
        std::min(0.15, std::sqrt(totalArea / static_cast<double>(std::max<uint64_t>(count, 1)) / 4));
    double areaSoFar = 0.0;
    uint64_t added = 0;
    for (const LeafCloud& cloud : site.leafClouds) {
        areaSoFar += cloud.leafArea;
        const bool isLast = &cloud == &site.leafClouds.back();
        const auto upTo = isLast ? count : static_cast<uint64_t>(static_cast<double>(count) * areaSoFar / totalArea);
        beginObject(site.mesh, "leaves", false);
        for (; added < upTo; ++added) addLeaf(site, cloud, halfWidth, random);
    }
}

}  // namespace manylight::courtyard
