#include "engine/scene/normalise.h"

#include "tests/unit/import_test_support.h"

#include <limits>
#include <random>

namespace manylight::testing {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

RawScene soup(size_t triangles, double scale, const glm::dvec3& offset) {
    RawScene raw;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
    raw.materials.emplace_back();
    for (uint32_t t = 0; t < triangles; ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            RawVertex vertex;
            vertex.position = scale * (glm::dvec3(coordinate(random), coordinate(random), coordinate(random)) + offset);
            vertex.normal = {coordinate(random), coordinate(random), coordinate(random)};
            vertex.hasNormal = true;
            raw.vertices.push_back(vertex);
        }
        raw.triangles.push_back({{3 * t, 3 * t + 1, 3 * t + 2}, 0, t});
    }
    raw.lights.push_back({.type = LightType::Point,
                          .name = "lamp",
                          .position = scale * offset,
                          .emission = glm::dvec3(3.0, 2.0, 1.0) * scale * scale});
    raw.cameras.push_back({.name = "eye",
                           .origin = scale * (offset + glm::dvec3(0.3, 0.2, 5.0)),
                           .forward = {0, 0, -2},
                           .up = {0, 1, 0.5},
                           .verticalFov = 0.7,
                           .resolution = {}});
    return raw;
}

RawScene oneTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    RawScene raw;
    raw.materials.emplace_back();
    for (const glm::dvec3& p : {a, b, c}) raw.vertices.push_back({.position = p});
    raw.triangles.push_back({{0, 1, 2}, 0, 0});
    return raw;
}

double diagonal(const Scene& scene) { return glm::length(glm::dvec3(scene.boundsMax) - glm::dvec3(scene.boundsMin)); }

TEST(Normalise, DiagonalIsInOneToTwoAndFrameLeadsBack) {
    for (const double scale : {1e-9, 0.3, 1.0, 7.0, 1e12}) {
        const RawScene raw = soup(50, scale, {4, -5, 6});
        const Scene scene = normalise(RawScene(raw));
        EXPECT_GE(diagonal(scene), 1.0);
        EXPECT_LT(diagonal(scene), 2.0);
        ASSERT_EQ(scene.triangles.size(), 50u);
        for (size_t t = 0; t < 50; ++t)
            for (size_t c = 0; c < 3; ++c)
                EXPECT_TRUE(isNear(filePosition(scene, t, c), raw.vertices[3 * t + c].position, 1e-6 * scale));
    }
}

TEST(Normalise, PowerOfTwoChangeOfUnitChangesOnlyTheExponent) {
    const Scene expected = normalise(soup(200, 1.0, {0.1, 0.7, -0.3}));
    for (const int k : {-60, -13, -1, 1, 8, 60}) {
        const Scene scene = normalise(soup(200, std::ldexp(1.0, k), {0.1, 0.7, -0.3}));
        EXPECT_EQ(scene.frame.exponent, expected.frame.exponent + k);
        ASSERT_EQ(scene.vertices.size(), expected.vertices.size());
        EXPECT_EQ(std::memcmp(scene.vertices.data(), expected.vertices.data(), sizeof(Vertex) * scene.vertices.size()),
                  0);
        EXPECT_EQ(scene.lights[0].position, expected.lights[0].position);
        EXPECT_EQ(scene.lights[0].emission, expected.lights[0].emission);
        EXPECT_EQ(scene.cameras[0].origin, expected.cameras[0].origin);
        EXPECT_EQ(scene.cameras[0].up, expected.cameras[0].up);
        EXPECT_EQ(scene.boundsMax, expected.boundsMax);
    }
}

TEST(Normalise, IrradianceOfAPointLightIsTheSameInBothFrames) {
    const RawScene raw = soup(20, 37.0, {1, 2, 3});
    const Scene scene = normalise(RawScene(raw));
    const double fileDistance = glm::distance(raw.lights[0].position, raw.vertices[0].position);
    const double distance = glm::distance(scene.lights[0].position, cornerOf(scene, 0, 0).position);
    EXPECT_NEAR(scene.lights[0].emission.x / (distance * distance),
                raw.lights[0].emission.x / (fileDistance * fileDistance), 1e-5);
}

TEST(Normalise, FarFromTheOriginLosesOnlyTheInputsRounding) {
    const Scene near = normalise(soup(100, 1.0, glm::dvec3(0.0)));
    const Scene far = normalise(soup(100, 1.0, glm::dvec3(1e8, -1e8, 1e8)));
    ASSERT_EQ(near.vertices.size(), far.vertices.size());
    for (size_t i = 0; i < near.vertices.size(); ++i)
        EXPECT_LT(glm::distance(near.vertices[i].position, far.vertices[i].position), 1e-7f);
}

TEST(Normalise, DropsUnusableTrianglesAndCountsThemByKind) {
    RawScene raw = soup(10, 1.0, glm::dvec3(0.0));
    const auto add = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        const auto first = static_cast<uint32_t>(raw.vertices.size());
        for (const glm::dvec3& p : {a, b, c}) raw.vertices.push_back({.position = p});
        raw.triangles.push_back({{first, first + 1, first + 2}, 0, static_cast<uint32_t>(raw.triangles.size())});
    };
    add({kNaN, 0, 0}, {1, 0, 0}, {0, 1, 0});
    add({kInfinity, 0, 0}, {1, 0, 0}, {0, 1, 0});
    add({1e300, 0, 0}, {1, 0, 0}, {0, 1, 0});
    add({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
    add({0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, {1, 0, 0});
    add({0.5, 0.5, 0.5}, {0.5 + 1e-12, 0.5, 0.5}, {0.5, 0.5 + 1e-12, 0.5});
    raw.triangles.push_back({{0, 1, 4000}, 0, 99});
    const Scene scene = normalise(std::move(raw));
    EXPECT_EQ(scene.triangles.size(), 10u);
    EXPECT_EQ(scene.warnings.count("triangles dropped: vertex not finite or beyond 1e150"), 3u);
    EXPECT_EQ(scene.warnings.count("triangles dropped: zero area"), 2u);
    EXPECT_EQ(scene.warnings.count("triangles dropped: zero area in single precision"), 1u);
    EXPECT_EQ(scene.warnings.count("triangles dropped: vertex index out of range"), 1u);
    EXPECT_EQ(scene.warnings.entries().at("triangles dropped: vertex index out of range").examples[0], "triangle 99");
    EXPECT_LT(diagonal(scene), 2.0);
}

TEST(Normalise, KeepsTinyScenesAndSlivers) {
    for (const double size : {1e-140, 2e-20, 2e-4, 1e140}) {
        const Scene scene = normalise(oneTriangle({0, 0, 0}, {size, 0, 0}, {0, size, 0}));
        ASSERT_EQ(scene.triangles.size(), 1u) << size;
        EXPECT_GE(diagonal(scene), 1.0);
    }
    EXPECT_EQ(normalise(oneTriangle({0, 0, 0}, {1, 0, 0}, {0.5, 1e-6, 0})).triangles.size(), 1u);
}

TEST(Normalise, OutlierThatCollapsesDoesNotSetTheFrame) {
    RawScene raw = soup(10, 1.0, glm::dvec3(0.0));
    const auto first = static_cast<uint32_t>(raw.vertices.size());
    for (const double dx : {0.0, 1e-9, 2e-9}) raw.vertices.push_back({.position = {1000 + dx, dx * dx * 1e9, 0}});
    raw.triangles.push_back({{first, first + 1, first + 2}, 0, 10});
    const Scene scene = normalise(std::move(raw));
    EXPECT_EQ(scene.triangles.size(), 10u);
    EXPECT_GE(diagonal(scene), 1.0);
}

TEST(Normalise, BadNormalsBecomeFlatAndAreCounted) {
    RawScene raw = oneTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const glm::dvec3 normals[] = {{kNaN, 0, 1}, {0, 0, 0}, {1e-42, 0, 0}};
    for (size_t i = 0; i < 3; ++i) {
        raw.vertices[i].normal = normals[i];
        raw.vertices[i].hasNormal = true;
        raw.vertices[i].uv = {i == 0 ? kInfinity : 0.5, 0.5};
    }
    const Scene scene = normalise(std::move(raw));
    for (const Vertex& vertex : scene.vertices) EXPECT_EQ(vertex.normal, glm::vec3(0.0f));
    EXPECT_EQ(scene.warnings.count("vertex normals removed: zero, denormal or not finite"), 3u);
    EXPECT_EQ(scene.warnings.count("texture coordinates set to zero: not finite"), 1u);
}

TEST(Normalise, WeldsEqualVerticesAndLeavesOutUnusedOnes) {
    RawScene raw = oneTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    raw.vertices.push_back({.position = {1e9, 0, 0}});
    for (const glm::dvec3& p : {glm::dvec3(1, 0, 0), glm::dvec3(1, 1, 0), glm::dvec3(-0.0, 1, 0)})
        raw.vertices.push_back({.position = p});
    raw.triangles.push_back({{4, 5, 6}, 0, 1});
    const Scene scene = normalise(std::move(raw));
    EXPECT_EQ(scene.vertices.size(), 4u);
    EXPECT_EQ(scene.triangles[1].vertex[0], scene.triangles[0].vertex[1]);
}

TEST(Normalise, EmptySceneStillHasCameraAndLight) {
    const Scene scene = normalise(RawScene{});
    EXPECT_EQ(scene.triangles.size(), 0u);
    EXPECT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.warnings.count("scenes without triangles"), 1u);
}

TEST(Normalise, DefaultCameraSeesAllOfTheBounds) {
    const Scene scene = normalise(oneTriangle({-5, 1, 2}, {40, 2, 3}, {3, 20, 9}));
    const Camera& camera = scene.cameras.at(0);
    EXPECT_NEAR(glm::dot(camera.forward, camera.up), 0.0f, 1e-6f);
    for (const Vertex& vertex : scene.vertices) {
        const glm::vec3 towards = glm::normalize(vertex.position - camera.origin);
        EXPECT_GT(glm::dot(towards, camera.forward), std::cos(0.5f * camera.verticalFov));
    }
    EXPECT_EQ(scene.warnings.count("scenes without a camera: given one that sees all of it"), 1u);
    EXPECT_EQ(scene.warnings.count("scenes without a light: given a point light near the camera"), 1u);
}

TEST(Normalise, ALightNearACameraOutOfAllReachIsStillFinite) {
    RawScene raw = oneTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    RawCamera camera;
    camera.origin = {0, 0, 1e25};
    camera.forward = {0, 0, -1};
    camera.up = {0, 1, 0};
    camera.verticalFov = 1.0;
    raw.cameras.push_back(camera);
    const Scene scene = normalise(std::move(raw));
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_GT(scene.lights[0].emission.x, 1e6f);
    EXPECT_LT(scene.lights[0].emission.x, 1e9f);
}

TEST(Normalise, ListedLightsAreFinalEvenIfThereAreNone) {
    RawScene raw = oneTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    raw.lightsAreFinal = true;
    const Scene scene = normalise(std::move(raw));
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_EQ(scene.warnings.count("scenes without a light: black, as the list of lights asks for"), 1u);
}

TEST(Normalise, RectangleEmitsTowardsCrossOfItsEdges) {
    RawScene raw;
    raw.rectLights.push_back(
        {.name = "panel", .center = {1, 2, 3}, .u = {2, 0, 0}, .v = {0, 0, 0.5}, .radiance = {4, 5, 6}});
    const Scene scene = normalise(std::move(raw));
    ASSERT_EQ(scene.triangles.size(), 2u);
    EXPECT_NEAR(totalArea(scene), 4 * 2 * 0.5, 1e-6);
    for (size_t t = 0; t < 2; ++t) EXPECT_LT(frontOf(scene, t).y, 0.0);
    EXPECT_EQ(scene.materials[0].albedo, glm::vec3(0.0f));
    EXPECT_EQ(scene.materials[0].emittedRadiance, glm::vec3(4, 5, 6));
}

TEST(Normalise, UnusableLightsAndCamerasAreCounted) {
    RawScene raw = oneTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    raw.lights.push_back(
        {.type = LightType::Point, .name = "a", .position = {kNaN, 0, 0}, .emission = glm::dvec3(1.0)});
    raw.lights.push_back(
        {.type = LightType::Directional, .name = "b", .direction = {0, 0, 0}, .emission = glm::dvec3(1.0)});
    raw.lights.push_back({.type = LightType::Point, .name = "c", .emission = {1, kNaN, -1}});
    raw.cameras.push_back({.name = "d", .forward = {0, 0, 0}, .resolution = {}});
    raw.cameras.push_back({.name = "e", .forward = {0, 3, 0}, .up = {0, 1, 0}, .resolution = {}});
    const Scene scene = normalise(std::move(raw));
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_GT(scene.lights[0].emission.x, 0.0f);
    EXPECT_EQ(scene.lights[0].emission.y, 0.0f);
    EXPECT_EQ(scene.lights[0].emission.z, 0.0f);
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_NEAR(glm::dot(scene.cameras[0].forward, scene.cameras[0].up), 0.0f, 1e-6f);
    EXPECT_EQ(scene.warnings.count("lights dropped: position or direction not usable"), 2u);
    EXPECT_EQ(scene.warnings.count("cameras dropped: origin, direction or field of view not usable"), 1u);
}

using NormaliseObj = SceneFiles;

TEST_F(NormaliseObj, ObjTextInAnotherUnitGivesTheSameBits) {
    std::mt19937 random(3);
    std::uniform_int_distribution<int> hundredths(-500, 500);
    std::vector<double> coordinates;
    for (int i = 0; i < 3 * 3 * 60; ++i) coordinates.push_back(hundredths(random) / 100.0);
    const auto text = [&](int exponent) {
        std::string obj;
        for (size_t i = 0; i < coordinates.size(); i += 3)
            obj += fmt::format("v {} {} {}\n", std::ldexp(coordinates[i], exponent),
                               std::ldexp(coordinates[i + 1], exponent), std::ldexp(coordinates[i + 2], exponent));
        for (size_t i = 0; i < coordinates.size() / 9; ++i)
            obj += "f " + fmt::format("{} {} {}\n", 3 * i + 1, 3 * i + 2, 3 * i + 3);
        return obj;
    };
    const Scene expected = import("a.obj", text(0));
    for (const int exponent : {-60, -7, 5, 60}) {
        const Scene scene = import("b.obj", text(exponent));
        ASSERT_EQ(scene.vertices.size(), expected.vertices.size());
        EXPECT_EQ(std::memcmp(scene.vertices.data(), expected.vertices.data(), sizeof(Vertex) * scene.vertices.size()),
                  0);
    }
}

}  // namespace
}  // namespace manylight::testing
