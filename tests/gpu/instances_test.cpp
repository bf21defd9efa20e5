// Two-level scenes show what the same scenes show with every mesh repeated, and let no light through.
#include "engine/scene/instances.h"
#include "engine/accel/embree_reference.h"
#include "engine/techniques/ray_caster.h"
#include "tests/gpu/instanced_scenes.h"
#include "tests/gpu/z_test.h"
#include "tests/unit/bvh_scenes.h"

namespace manylight::test {
namespace {

using Instances = GpuTest;

RenderSettings pictureSettings(uint32_t width, uint32_t height) {
    RenderSettings settings = plainSettings(width, height);
    settings.castShadows = true;
    settings.russianRoulette = true;
    settings.bounceCount = 5;
    settings.vplCount = 100;
    settings.lightSampleCount = 16;
    return settings;
}

double relativeDifference(const Image& a, const Image& b) {
    double difference = 0.0;
    for (size_t i = 0; i < a.texels.size(); ++i) difference += std::abs(double{a.texels[i]} - double{b.texels[i]});
    return difference / static_cast<double>(a.texels.size()) / meanOf(b);
}

TEST_F(Instances, AreSeenAsIfEveryMeshWereRepeated) {
    const Scene scene = roomOfInstances();
    const Scene repeated = flattened(scene);
    ASSERT_EQ(shownTriangles(scene), repeated.triangles.size());
    for (const Show show : {Show::Normal, Show::Albedo, Show::Position, Show::Material}) {
        RenderSettings settings = pictureSettings(64, 48);
        settings.show = show;
        EXPECT_LT(relativeDifference(render(scene, settings), render(repeated, settings)), 2e-4) << name(show);
    }
}

// The last bits of a ray's origin differ where it is taken into a mesh's frame, so that some rays at outlines meet
// something else, and light paths that do go elsewhere. Of direct light nothing else changes.
TEST_F(Instances, AreLitAsIfEveryMeshWereRepeated) {
    const Scene scene = roomOfInstances();
    const Scene repeated = flattened(scene);
    for (const Technique technique : {Technique::Deferred, Technique::PathTracer}) {
        RenderSettings settings = pictureSettings(32, 24);
        settings.technique = technique;
        EXPECT_LT(relativeDifference(render(scene, settings), render(repeated, settings)), 0.02) << name(technique);
        settings.lighting = Lighting::Local;
        EXPECT_LT(relativeDifference(render(scene, settings), render(repeated, settings)), 2e-3) << name(technique);
    }
    for (const Technique technique : {Technique::Forward, Technique::ForwardPrepass}) {
        RenderSettings settings = pictureSettings(32, 24);
        settings.technique = technique;
        settings.castShadows = false;  // which compile fast
        settings.lighting = Lighting::Local;
        EXPECT_LT(relativeDifference(render(scene, settings), render(repeated, settings)), 2e-3) << name(technique);
    }
}

TEST_F(Instances, VplsShowWhatThePathTracerShows) {
    const Scene scene = roomOfInstances();
    RenderSettings settings = pictureSettings(12, 9);
    settings.vplCount = 200;
    settings.clamp = ClampMode::Compensate;
    settings.clampBound = 3.0f;
    RenderSettings traced = settings;
    traced.technique = Technique::PathTracer;
    traced.clamp = ClampMode::Off;
    const PictureSamples truth = samplePictures(scene, traced, {.first = 1000, .count = 24, .frames = 40});
    const PictureSamples deferred = samplePictures(scene, settings, {.count = 24, .frames = 4});
    expectSameMeans(deferred, truth, 0.008);
    EXPECT_TRUE(toldApart(scaled(deferred, 1.04), truth));
}

/// Spheres about 0.3 across, turned and stretched, far enough from each other.
Scene scatteredSpheres(uint32_t count) {
    Scene scene = test::closedBox(12, 0.5f);
    scene.materials.resize(1);
    endMesh(scene);
    std::mt19937 random(11);
    for (uint32_t i = 0; i < count; ++i) {
        const glm::vec3 scale = glm::vec3(0.15f) + 0.06f * randomPoint(random);
        addInstance(scene, 0, turnedBy(3.0f * randomPoint(random).x, randomPoint(random) + glm::vec3(0, 0, 1), scale),
                    {-0.4f + 0.4f * static_cast<float>(i % 3), -0.4f + 0.4f * static_cast<float>(i / 3 % 3),
                     -0.3f + 0.5f * static_cast<float>(i / 9)});
    }
    return scene;
}

struct Answers {
    std::vector<uint32_t> occluded;
    std::vector<shared::RayHit> hits;
};

Answers cast(const Scene& scene, const RaySet& rays) {
    RayCaster caster(device(), scene, buildBvh(scene));
    caster.load(rays);
    caster.trace(RayKind::AnyHit);
    Answers answers{caster.occludedFlags(), {}};
    caster.trace(RayKind::ClosestHit);
    answers.hits = caster.hits();
    for (shared::RayHit& hit : answers.hits)
        if (hit.triangle != shared::kNoHit) hit.triangle = caster.gpuScene().numbers.flattenedTriangle(hit.triangle);
    return answers;
}

TEST_F(Instances, NoRayEscapesThroughEdgesAndVertices) {
    const Scene scene = scatteredSpheres(18);
    Scene mesh = scene;
    mesh.instances.clear();
    RaySet rays;
    for (uint32_t i = 0; i < scene.instances.size(); ++i)
        for (shared::RayQuery ray : raysAtEdges(mesh, 10000, i)) {
            const MeshInstance& instance = scene.instances[i];
            const glm::vec3 target = placed(instance, ray.origin + ray.direction);
            ray.origin = placed(instance, 0.5f * ray.origin);
            ray.direction = target - ray.origin;
            rays.push_back(ray);
        }
    const Answers answers = cast(scene, rays);
    EXPECT_EQ(std::ranges::count(answers.occluded, 0u), 0);
    EXPECT_EQ(std::ranges::count(answers.hits, shared::kNoHit, &shared::RayHit::triangle), 0);
}

TEST_F(Instances, RaysMeetWhatTheyMeetAmongRepeatedMeshes) {
    const Scene scene = scatteredSpheres(18);
    const EmbreeReference embree(flattened(scene), true);
    const RaySet rays = randomRays(60000, 12);
    const Answers answers = cast(scene, rays);
    uint32_t differences = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        const std::optional<ClosestHit> expected = embree.closest(rays[i]);
        const shared::RayHit& hit = answers.hits[i];
        differences += (answers.occluded[i] != 0) != embree.occluded(rays[i]) ? 1 : 0;
        differences += expected.has_value() != (hit.triangle != shared::kNoHit) ? 1 : 0;
        if (!expected || hit.triangle == shared::kNoHit) continue;
        ASSERT_NEAR(hit.t, expected->t, 1e-4f * expected->t + 1e-5f) << "ray " << i;
        differences += hit.triangle != expected->triangle ? 1 : 0;
    }
    EXPECT_LE(differences, 30u);  // at outlines and edges, where rounding decides
}

TEST_F(Instances, LightStaysInAClosedMesh) {
    Scene scene = scatteredSpheres(18);
    scene.materials[0].albedo = glm::vec3(0.9f);
    const uint32_t wall = addMaterial(scene, glm::vec3(0.9f));
    addRoom(scene, glm::vec3(-0.57f), glm::vec3(0.57f), wall);
    endMesh(scene);
    addInstance(scene, 1, glm::mat3(1.0f), glm::vec3(0.0f));
    for (const uint32_t i : {0u, 4u, 10u, 17u})
        scene.lights.push_back(pointLight(scene.instances[i].center + glm::vec3(0.02f, 0.03f, 0.01f), glm::vec3(1.0f)));
    addCamera(scene, {0.2f, 0.2f, 0.5f}, {-0.1f, -0.1f, -0.5f}, 1.4f);
    scene = finishedInstances(std::move(scene));
    RenderSettings settings = pictureSettings(32, 24);
    settings.bounceCount = 20;
    for (const Technique technique : {Technique::Deferred, Technique::PathTracer}) {
        settings.technique = technique;
        EXPECT_EQ(largestOf(render(scene, settings, 2)), 0.0) << name(technique);
    }
    settings.technique = Technique::Deferred;
    EXPECT_GT(renderVpls(scene, settings).status.vplsTraced, 1000u);
}

}  // namespace
}  // namespace manylight::test
