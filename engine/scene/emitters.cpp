#include "engine/scene/emitters.h"

#include "engine/core/finite.h"
#include "engine/scene/alias_table.h"
#include "engine/scene/instances.h"
#include "engine/scene/texture_mean.h"
#include "shaders/shared/constants.h"
#include "shaders/shared/material.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

using shared::Emitter;

constexpr double kPi = shared::kPi;
constexpr double kDefensiveShare = 0.1;
constexpr double kSteepestRange = 1e9;  // no two points of a scene are so close: no infinity meets a zero

double meanChannel(glm::vec3 v) { return (double{v.x} + double{v.y} + double{v.z}) / 3.0; }

/// Integral of the spot's falloff over solid angle, exact for a falloff linear in the angle.
double spotSolidAngle(const Light& light) {
    const double cutoff = std::acos(double{light.cosCutoff});
    const double beam = std::acos(double{light.cosBeam});
    const double full = 2.0 * kPi * (1.0 - double{light.cosBeam});
    if (cutoff - beam < 1e-9) return full;
    // int_beam^cutoff (cutoff - t) / (cutoff - beam) sin t dt
    const double ramp = ((cutoff - beam) * std::cos(beam) - std::sin(cutoff) + std::sin(beam)) / (cutoff - beam);
    return full + 2.0 * kPi * ramp;
}

Emitter fromLight(const Light& light, uint32_t kind) {
    Emitter emitter{};
    emitter.position = light.position;
    emitter.kind = kind;
    emitter.edge1 = light.direction;
    emitter.emission = light.emission;
    emitter.cosCutoff = light.cosCutoff;
    emitter.cosBeam = light.cosBeam;
    emitter.inverseRange = static_cast<float>(std::min(1.0 / double{light.range}, kSteepestRange));
    emitter.emissionTexture = shared::kNoTexture;
    return emitter;
}

struct Candidate {
    Emitter emitter;
    double power;
    bool isArea;
};

Candidate fromLight(const Light& light, double sceneRadius) {
    const double emission = meanChannel(light.emission);
    const double disk = kPi * sceneRadius * sceneRadius;
    switch (light.type) {
        case LightType::Point:
            return {fromLight(light, shared::kEmitterPoint), emission * 4.0 * kPi, false};
        case LightType::Spot:
            return {fromLight(light, shared::kEmitterSpot), emission * spotSolidAngle(light), false};
        case LightType::Directional:
            return {fromLight(light, shared::kEmitterDirectional), emission * disk, false};
        case LightType::Constant:
            break;
    }
    return {fromLight(light, shared::kEmitterEnvironment), emission * 4.0 * kPi * disk, true};
}

Candidate fromMap(const EnvironmentTable& environment, double sceneRadius) {
    Emitter emitter{};
    emitter.kind = shared::kEmitterEnvironment;
    emitter.emissionTexture = shared::kNoTexture;
    return {emitter, environment.integral * kPi * sceneRadius * sceneRadius, true};
}

Candidate fromTriangle(uint32_t number, const std::array<glm::vec3, 3>& corners, const glm::vec3& radiance,
                       double emission) {
    Emitter emitter{};
    emitter.kind = shared::kEmitterTriangle;
    emitter.emissionTexture = shared::kNoTexture;
    emitter.position = corners[0];
    emitter.edge1 = corners[1] - corners[0];
    emitter.edge2 = corners[2] - corners[0];
    emitter.emission = radiance;
    const double area = 0.5 * glm::length(glm::cross(glm::dvec3(emitter.edge1), glm::dvec3(emitter.edge2)));
    emitter.area = static_cast<float>(area);
    emitter.triangle = number;
    return {emitter, emission * area * kPi, true};
}

/// `emissions`: of the materials. Meshes that do not shine are passed over, however often they are shown.
void addTriangles(const Scene& scene, const std::vector<double>& emissions, std::vector<Candidate>& candidates) {
    if (std::ranges::none_of(emissions, [](double emission) { return emission > 0.0; })) return;
    InstanceList list = listInstances(scene);
    for (SharedMesh& mesh : list.meshes) {
        const auto first = scene.triangles.begin() + mesh.firstTriangle;
        const bool shines = std::any_of(first, first + mesh.triangleCount,
                                        [&](const Triangle& triangle) { return emissions[triangle.material] > 0.0; });
        if (!shines) mesh.triangleCount = 0;
    }
    forEachTriangle(scene, list,
                    [&](uint32_t number, const Triangle& triangle, const std::array<glm::vec3, 3>& corners) {
                        const double emission = emissions[triangle.material];
                        const glm::vec3& radiance = scene.materials[triangle.material].emittedRadiance;
                        if (emission > 0.0) candidates.push_back(fromTriangle(number, corners, radiance, emission));
                    });
}

/// Fills the chosen field and returns the alias table of the choice, if there is anything to choose.
template <typename Includes>
std::vector<AliasSlot> distribute(std::vector<Candidate>& candidates, Includes includes, float Emitter::*probability) {
    double total = 0.0;
    size_t count = 0;
    for (const Candidate& candidate : candidates)
        if (includes(candidate)) total += candidate.power, ++count;
    std::vector<double> probabilities;
    for (Candidate& candidate : candidates) {
        double p = 0.0;
        if (includes(candidate)) {
            const double share = total > 0.0 && hasFiniteBits(static_cast<float>(total))
                                     ? candidate.power / total
                                     : 1.0 / static_cast<double>(count);
            p = (1.0 - kDefensiveShare) * share + kDefensiveShare / static_cast<double>(count);
        }
        probabilities.push_back(p);
        candidate.emitter.*probability = static_cast<float>(p);
    }
    return count > 0 ? buildAliasTable(probabilities) : std::vector<AliasSlot>(candidates.size());
}

}  // namespace

BoundingSphere boundingSphere(const Scene& scene) {
    const float radius = 0.5f * glm::length(scene.boundsMax - scene.boundsMin);
    // A little larger: corners of the bounds lie on the sphere and must be covered.
    return {0.5f * (scene.boundsMin + scene.boundsMax), std::max(radius * 1.001f, 1e-3f)};
}

double meanEmission(const Scene& scene, const Material& material) {
    glm::dvec3 radiance = material.emittedRadiance;
    if (material.emissionTexture.exists() && radiance != glm::dvec3(0.0))
        radiance *= meanOfTexture(scene.textures[static_cast<size_t>(material.emissionTexture.texture)]);
    return meanChannel(glm::vec3(radiance));
}

EmitterTable buildEmitterTable(const Scene& scene, float sceneRadius, const EnvironmentTable& environment) {
    std::vector<Candidate> candidates;
    EmitterTable table;
    if (environment.exists()) candidates.push_back(fromMap(environment, double{sceneRadius}));
    for (const Light& light : scene.lights) {
        if (light.type == LightType::Constant && environment.exists()) continue;
        candidates.push_back(fromLight(light, double{sceneRadius}));
        if (light.type == LightType::Constant) table.environmentRadiance += light.emission;
    }
    std::vector<double> emissions;
    for (const Material& material : scene.materials) emissions.push_back(meanEmission(scene, material));
    addTriangles(scene, emissions, candidates);

    std::erase_if(candidates, [](const Candidate& candidate) { return !(candidate.power > 0.0); });
    std::stable_partition(candidates.begin(), candidates.end(), [](const Candidate& c) { return !c.isArea; });
    const std::vector<AliasSlot> slots = distribute(
        candidates, [](const Candidate&) { return true; }, &Emitter::probability);
    const std::vector<AliasSlot> areaSlots = distribute(
        candidates, [](const Candidate& c) { return c.isArea; }, &Emitter::areaProbability);
    for (size_t i = 0; i < candidates.size(); ++i)
        table.choices.push_back({slots[i].threshold, slots[i].alias, areaSlots[i].threshold, areaSlots[i].alias});
    double areaPower = 0.0;
    for (const Candidate& candidate : candidates) {
        table.emitters.push_back(candidate.emitter);
        table.totalPower += candidate.power;
        areaPower += candidate.isArea ? candidate.power : 0.0;
        if (candidate.isArea)
            ++table.areaLightCount;
        else
            ++table.deltaLightCount;
        if (candidate.emitter.kind != shared::kEmitterEnvironment) continue;
        table.environmentProbability += double{candidate.emitter.probability};
        table.areaEnvironmentProbability += double{candidate.emitter.areaProbability};
    }
    if (table.areaLightCount > 0) {
        table.areaPowerShare = (1.0 - kDefensiveShare) / areaPower;
        table.areaEqualShare = kDefensiveShare / static_cast<double>(table.areaLightCount);
    }
    if (!candidates.empty()) {
        table.powerShare = (1.0 - kDefensiveShare) / table.totalPower;
        table.equalShare = kDefensiveShare / static_cast<double>(candidates.size());
    }
    return table;
}

}  // namespace manylight
