// The same scene in Embree: the other opinion on what a ray hits, and the speed to be measured against.
#pragma once

#include "engine/accel/ray_sets.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace manylight {

struct ClosestHit {
    float t = 0.0f;
    uint32_t triangle = 0;         // index into Scene::triangles
    glm::vec2 barycentrics{0.0f};  // weights of the second and third corner
    glm::vec3 normal{0.0f};        // geometric, not normalised, counter-clockwise side
};

/// Single-ray queries (rtcOccluded1, rtcIntersect1) in Embree's robust mode or its default one. Thread-safe.
class EmbreeReference {
  public:
    explicit EmbreeReference(const Scene& scene, bool robust = false);
    ~EmbreeReference();
    EmbreeReference(EmbreeReference&&) noexcept;
    EmbreeReference& operator=(EmbreeReference&&) noexcept;

    bool occluded(const shared::RayQuery& ray) const;
    std::optional<ClosestHit> closest(const shared::RayQuery& ray) const;

    /// Traces all rays once on `threadCount` threads, each taking one contiguous share, and returns millions per
    /// second.
    double millionRaysPerSecond(std::span<const shared::RayQuery> rays, RayKind kind, uint32_t threadCount = 2) const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace manylight
