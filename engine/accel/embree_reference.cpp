#include "engine/accel/embree_reference.h"

#include "engine/accel/embree.h"
#include "engine/core/error.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <thread>

namespace manylight {

struct EmbreeReference::Implementation {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    Implementation() = default;
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;
    ~Implementation() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
};

namespace {

RTCRay toEmbree(const shared::RayQuery& query) {
    RTCRay ray{};
    ray.org_x = query.origin.x;
    ray.org_y = query.origin.y;
    ray.org_z = query.origin.z;
    ray.dir_x = query.direction.x;
    ray.dir_y = query.direction.y;
    ray.dir_z = query.direction.z;
    ray.tnear = 0.0f;
    ray.tfar = query.tMax;
    ray.mask = ~0u;
    return ray;
}

void traceOccluded(RTCScene scene, RTCRay& ray) {
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#endif
}

void traceClosest(RTCScene scene, RTCRayHit& ray) {
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
#endif
}

void addTriangles(RTCDevice device, RTCScene target, const Scene& scene) {
    RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions =
        static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                        sizeof(glm::vec3), std::max<size_t>(scene.vertices.size(), 1)));
    auto* indices = static_cast<uint32_t*>(rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                   3 * sizeof(uint32_t), scene.triangles.size()));
    if (!positions || !indices) fail("Embree: no memory for {} triangles", scene.triangles.size());
    for (const Vertex& vertex : scene.vertices) *positions++ = vertex.position;
    for (const Triangle& triangle : scene.triangles) indices = std::ranges::copy(triangle.vertex, indices).out;
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(target, mesh);
    rtcReleaseGeometry(mesh);
}

}  // namespace

EmbreeReference::EmbreeReference(const Scene& scene, bool robust)
    : implementation_(std::make_unique<Implementation>()) {
    implementation_->device = rtcNewDevice(nullptr);
    if (!implementation_->device) fail("Embree: no device (error {})", static_cast<int>(rtcGetDeviceError(nullptr)));
    implementation_->scene = rtcNewScene(implementation_->device);
    if (robust) rtcSetSceneFlags(implementation_->scene, RTC_SCENE_FLAG_ROBUST);
    if (!scene.triangles.empty()) addTriangles(implementation_->device, implementation_->scene, scene);
    rtcCommitScene(implementation_->scene);
}

EmbreeReference::~EmbreeReference() = default;
EmbreeReference::EmbreeReference(EmbreeReference&&) noexcept = default;
EmbreeReference& EmbreeReference::operator=(EmbreeReference&&) noexcept = default;

bool EmbreeReference::occluded(const shared::RayQuery& query) const {
    RTCRay ray = toEmbree(query);
    traceOccluded(implementation_->scene, ray);
    return ray.tfar < 0.0f;
}

std::optional<ClosestHit> EmbreeReference::closest(const shared::RayQuery& query) const {
    RTCRayHit hit{};
    hit.ray = toEmbree(query);
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    traceClosest(implementation_->scene, hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return ClosestHit{hit.ray.tfar, hit.hit.primID, {hit.hit.u, hit.hit.v}, {hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z}};
}

double EmbreeReference::millionRaysPerSecond(std::span<const shared::RayQuery> rays, RayKind kind,
                                             uint32_t threadCount) const {
    const auto traceShare = [&](std::span<const shared::RayQuery> share, uint32_t& hitCount) {
        uint32_t hits = 0;
        if (kind == RayKind::AnyHit) {
            for (const shared::RayQuery& ray : share) hits += occluded(ray) ? 1 : 0;
        } else {
            for (const shared::RayQuery& ray : share) hits += closest(ray) ? 1 : 0;
        }
        hitCount = hits;  // used, so that no compiler drops the rays
    };
    std::vector<uint32_t> hitCounts(threadCount);
    const auto start = std::chrono::steady_clock::now();
    {
        std::vector<std::jthread> threads;
        for (uint32_t i = 0; i < threadCount; ++i) {
            const size_t begin = rays.size() * i / threadCount;
            const size_t end = rays.size() * (i + 1) / threadCount;
            threads.emplace_back(traceShare, rays.subspan(begin, end - begin), std::ref(hitCounts[i]));
        }
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    return static_cast<double>(rays.size()) * 1e-6 / elapsed.count();
}

}  // namespace manylight
