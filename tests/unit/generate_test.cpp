#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/scene/generate/cornell_box.h"
#include "engine/scene/generate/courtyard.h"
#include "engine/scene/generate/cube.h"
#include "engine/scene/generate/shapes.h"
#include "engine/scene/import.h"
#include "shaders/shared/constants.h"

namespace manylight {
namespace {

namespace fs = std::filesystem;

using Corners = std::array<glm::dvec3, 3>;

std::vector<Corners> trianglesOf(const Mesh& mesh, size_t firstFace, size_t endFace) {
    std::vector<Corners> triangles;
    for (size_t i = firstFace; i < endFace; ++i) {
        const MeshFace& face = mesh.faces[i];
        for (uint32_t k = 2; k < face.cornerCount(); ++k)
            triangles.push_back({mesh.positions[face.position[0]], mesh.positions[face.position[k - 1]],
                                 mesh.positions[face.position[k]]});
    }
    return triangles;
}

std::vector<Corners> trianglesOf(const Mesh& mesh) { return trianglesOf(mesh, 0, mesh.faces.size()); }

std::vector<Corners> trianglesOfObject(const Mesh& mesh, size_t object) {
    const size_t end = object + 1 < mesh.objects.size() ? mesh.objects[object + 1].firstFace : mesh.faces.size();
    return trianglesOf(mesh, mesh.objects[object].firstFace, end);
}

std::vector<Corners> trianglesOfObject(const Mesh& mesh, const std::string& name) {
    for (size_t i = 0; i < mesh.objects.size(); ++i)
        if (mesh.objects[i].name == name) return trianglesOfObject(mesh, i);
    return {};
}

double areaOf(const Corners& t) { return 0.5 * glm::length(glm::cross(t[1] - t[0], t[2] - t[0])); }

double areaOf(const std::vector<Corners>& triangles) {
    double area = 0.0;
    for (const Corners& t : triangles) area += areaOf(t);
    return area;
}

/// Positive if the faces of a closed surface are turned outwards.
double signedVolume(const std::vector<Corners>& triangles) {
    double volume = 0.0;
    const glm::dvec3 origin = triangles.front()[0];
    for (const Corners& t : triangles)
        volume += glm::dot(t[0] - origin, glm::cross(t[1] - origin, t[2] - origin)) / 6.0;
    return volume;
}

/// The vector areas of a closed surface add up to zero.
double openness(const std::vector<Corners>& triangles) {
    glm::dvec3 sum(0.0);
    for (const Corners& t : triangles) sum += 0.5 * glm::cross(t[1] - t[0], t[2] - t[0]);
    return glm::length(sum);
}

void expectGoodSolids(const Mesh& mesh) {
    for (size_t i = 0; i < mesh.objects.size(); ++i) {
        const std::vector<Corners> triangles = trianglesOfObject(mesh, i);
        if (!mesh.objects[i].closed) continue;
        ASSERT_FALSE(triangles.empty()) << mesh.objects[i].name;
        EXPECT_GT(signedVolume(triangles), 0.0) << mesh.objects[i].name;
        EXPECT_LT(openness(triangles), 1e-4 * areaOf(triangles)) << mesh.objects[i].name;
    }
    size_t degenerate = 0;
    for (const Corners& t : trianglesOf(mesh)) degenerate += areaOf(t) < 1e-10 ? 1 : 0;
    EXPECT_EQ(degenerate, 0u);
}

void expectNormalsAgreeWithWinding(const Mesh& mesh) {
    for (const MeshFace& face : mesh.faces) {
        if (face.normal[0] == kNoIndex) continue;
        const glm::dvec3 a = mesh.positions[face.position[0]];
        const glm::dvec3 winding =
            glm::cross(mesh.positions[face.position[1]] - a, mesh.positions[face.position[2]] - a);
        for (uint32_t corner = 0; corner < face.cornerCount(); ++corner)
            ASSERT_GT(glm::dot(winding, mesh.normals[face.normal[corner]]), 0.0);
    }
}

Mesh emptyMesh() {
    Mesh mesh;
    addMaterial(mesh, "white", glm::dvec3(0.8));
    beginObject(mesh, "shape");
    return mesh;
}

TEST(ShapesTest, VolumesAreThoseOfTheSolids) {
    const Placement place = turned({3.0, -2.0, 5.0}, 0.7);
    Mesh box = emptyMesh();
    addBox(box, place, {-1, 0, -2}, {1, 3, 2}, 0);
    EXPECT_NEAR(signedVolume(trianglesOf(box)), 24.0, 1e-3);

    Mesh cylinder = emptyMesh();
    addLathe(cylinder, place, {{2.0, 0.0}, {2.0, 3.0}}, 400, 0);
    EXPECT_NEAR(signedVolume(trianglesOf(cylinder)), 12.0 * double{shared::kPi}, 2e-3 * 12 * double{shared::kPi});

    Mesh sphere = emptyMesh();
    addSphere(sphere, place, 1.5, 1.5, 200, 0);
    EXPECT_NEAR(signedVolume(trianglesOf(sphere)), 4.5 * double{shared::kPi}, 2e-3 * 4.5 * double{shared::kPi});

    // A square tube around a rectangle of half sizes 3 and 2, from there one unit outwards: 8 * 6 - 6 * 4.
    Mesh ring = emptyMesh();
    addRectangularRing(ring, {3.0, 2.0}, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0);
    EXPECT_NEAR(signedVolume(trianglesOf(ring)), 24.0, 1e-9);

    Mesh slab = emptyMesh();
    addSlab(slab, place, {{0, 0}, {1, 1}, {2, 0}}, {{0, 2}, {1, 2}, {2, 2}}, 0.5, 0);
    EXPECT_NEAR(signedVolume(trianglesOf(slab)), 1.5, 1e-3);

    for (const Mesh* mesh : {&box, &cylinder, &sphere, &ring, &slab}) {
        expectGoodSolids(*mesh);
        expectNormalsAgreeWithWinding(*mesh);
    }
}

TEST(CornellBoxTest, HasThePublishedDimensions) {
    const GeneratedScene scene = generateCornellBox();
    const Mesh& mesh = scene.mesh;
    EXPECT_NEAR(areaOf(trianglesOfObject(mesh, "light")), 130.0 * 105.0, 1e-9);
    EXPECT_NEAR(areaOf(trianglesOfObject(mesh, "ceiling")), 556.0 * 559.2 - 130.0 * 105.0, 1e-9);
    EXPECT_NEAR(areaOf(trianglesOfObject(mesh, "floor")), 0.5 * (552.8 + 549.6) * 559.2, 1e-9);
    EXPECT_NEAR(areaOf(trianglesOfObject(mesh, "right_wall")), 559.2 * 548.8, 1e-9);

    glm::dvec3 low(1e9);
    glm::dvec3 high(-1e9);
    for (const glm::dvec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    EXPECT_EQ(low, glm::dvec3(0.0));
    EXPECT_EQ(high, glm::dvec3(556.0, 548.8, 559.2));
    expectGoodSolids(mesh);  // the two blocks

    // Everything faces the inside of the room: the light and the ceiling down, the floor up.
    for (const char* name : {"light", "ceiling"})
        for (const Corners& t : trianglesOfObject(mesh, name)) EXPECT_LT(glm::cross(t[1] - t[0], t[2] - t[0]).y, 0.0);
    for (const Corners& t : trianglesOfObject(mesh, "floor")) EXPECT_GT(glm::cross(t[1] - t[0], t[2] - t[0]).y, 0.0);
}

TEST(CubeTest, IsAUnitCubeInSixGroups) {
    const GeneratedScene scene = generateCube();
    EXPECT_EQ(scene.mesh.faces.size(), 6u);
    EXPECT_TRUE(scene.mesh.normals.empty());
    std::set<std::string> names;
    for (const MeshObject& object : scene.mesh.objects) names.insert(object.name);
    EXPECT_EQ(names.size(), 6u);
    EXPECT_NEAR(signedVolume(trianglesOf(scene.mesh)), 1.0, 1e-12);
}

TEST(CourtyardTest, MeetsTheTriangleTarget) {
    for (const uint32_t target : {5'000u, 12'345u, 65'000u, 400'000u})
        EXPECT_NEAR(static_cast<double>(triangleCount(generateCourtyard({.triangleTarget = target}).mesh)), target,
                    1.0);
    for (uint32_t depth = 1; depth <= 6; ++depth)
        EXPECT_NEAR(static_cast<double>(triangleCount(generateCourtyard({65'000, depth, 3}).mesh)), 65'000.0, 1.0);
}

TEST(CourtyardTest, SolidsAreClosedAndFaceOutwards) {
    for (const uint32_t target : {5'000u, 65'000u, 300'000u}) {
        const Mesh mesh = generateCourtyard({.triangleTarget = target, .depth = target > 65'000 ? 4u : 2u}).mesh;
        expectGoodSolids(mesh);
        expectNormalsAgreeWithWinding(mesh);
    }
}

TEST(CourtyardTest, IsAFunctionOfItsSeed) {
    const std::string text = objText(generateCourtyard({.triangleTarget = 20'000, .seed = 5}));
    EXPECT_TRUE(text == objText(generateCourtyard({.triangleTarget = 20'000, .seed = 5})));
    EXPECT_FALSE(text == objText(generateCourtyard({.triangleTarget = 20'000, .seed = 6})));
}

TEST(CourtyardTest, ReflectancesArePlausible) {
    for (const MeshMaterial& material : generateCourtyard({}).mesh.materials)
        for (int c = 0; c < 3; ++c) {
            EXPECT_GE(material.albedo[c], 0.05) << material.name;
            EXPECT_LE(material.albedo[c], 0.8) << material.name;
        }
}

/// Surfaces along a ray, by the test of Moeller and Trumbore (1997) without culling.
size_t surfacesAlong(const std::vector<Corners>& triangles, const glm::dvec3& origin, const glm::dvec3& direction) {
    size_t count = 0;
    for (const Corners& t : triangles) {
        const glm::dvec3 edge1 = t[1] - t[0];
        const glm::dvec3 edge2 = t[2] - t[0];
        const glm::dvec3 p = glm::cross(direction, edge2);
        const double inverse = 1.0 / glm::dot(edge1, p);
        const glm::dvec3 s = origin - t[0];
        const double u = glm::dot(s, p) * inverse;
        if (!(u >= 0.0 && u <= 1.0)) continue;
        const glm::dvec3 q = glm::cross(s, edge1);
        const double v = glm::dot(direction, q) * inverse;
        if (v >= 0.0 && u + v <= 1.0 && glm::dot(edge2, q) * inverse > 0.0) ++count;
    }
    return count;
}

double meanDepthComplexity(const GeneratedScene& scene) {
    const auto vector = [](const Json& json) { return glm::dvec3(json.at(0), json.at(1), json.at(2)); };
    const Json& camera = scene.sidecar.at("camera");
    const glm::dvec3 origin = vector(camera.at("origin"));
    const glm::dvec3 forward = glm::normalize(vector(camera.at("target")) - origin);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
    const glm::dvec3 up = glm::cross(right, forward);
    const double slope = std::tan(glm::radians(camera.at("fov_y_deg").get<double>()) / 2);
    const std::vector<Corners> triangles = trianglesOf(scene.mesh);
    constexpr int kWidth = 28;
    constexpr int kHeight = 21;
    size_t surfaces = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const double right01 = (2 * x + 1.0) / kWidth - 1.0;
            const double up01 = 1.0 - (2 * y + 1.0) / kHeight;
            surfaces +=
                surfacesAlong(triangles, origin, forward + slope * (right01 * kWidth / kHeight * right + up01 * up));
        }
    return static_cast<double>(surfaces) / (kWidth * kHeight);
}

TEST(CourtyardTest, DepthComplexityIsThatOfARealScene) {
    const double byDefault = meanDepthComplexity(generateCourtyard({}));
    EXPECT_GT(byDefault, 6.0);
    EXPECT_LT(byDefault, 8.0);
    EXPECT_GT(meanDepthComplexity(generateCourtyard({.depth = 6})), byDefault + 0.3);
}

TEST(CourtyardTest, RefusesWhatItCannotDo) {
    EXPECT_THROW(generateCourtyard({.triangleTarget = 100}), Error);
    EXPECT_THROW(generateCourtyard({.depth = 0}), Error);
    EXPECT_THROW(generateCourtyard({.depth = 7}), Error);
    EXPECT_THROW(generateCourtyard({.triangleTarget = 4'000'000'000u}), Error);
    EXPECT_THROW(courtyardLightFrom("moon"), Error);
}

/// A folder of this test's own, removed at the end.
class WrittenSceneTest : public testing::Test {
  protected:
    WrittenSceneTest() { fs::remove_all(folder_); }
    ~WrittenSceneTest() override { fs::remove_all(folder_); }

    const fs::path folder_ =
        fs::path(testing::TempDir()) /
        fmt::format("manylight_generate_{}", testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(WrittenSceneTest, ImportsWithTheSameCounts) {
    for (const GeneratedScene& scene :
         {generateCornellBox(), generateCube(), generateCourtyard({.triangleTarget = 20'000}),
          generateCourtyard({.triangleTarget = 6'000, .light = CourtyardLight::Sky})}) {
        writeGeneratedScene(scene, folder_);
        const Scene imported = importScene(folder_ / (scene.name + ".json"));
        EXPECT_EQ(imported.triangles.size(), triangleCount(scene.mesh)) << scene.name;
        EXPECT_EQ(imported.lights.size(), scene.sidecar.at("lights").size()) << scene.name;
        ASSERT_EQ(imported.cameras.size(), 1u) << scene.name;
        EXPECT_EQ(imported.cameras[0].resolution->x, 512u) << scene.name;
        EXPECT_EQ(imported.warnings.empty(), scene.hasMaterialFile) << scene.name << "\n" << imported.warnings.toText();
    }
}

TEST_F(WrittenSceneTest, TheScenesOfTheRepositoryAreUpToDate) {
    for (const GeneratedScene& scene : {generateCornellBox(), generateCube()})
        for (const fs::path& path : writeGeneratedScene(scene, folder_)) {
            const fs::path inRepository = fs::path(MANYLIGHT_SOURCE_DIR) / "scenes" / fs::relative(path, folder_);
            EXPECT_EQ(readTextFile(path), readTextFile(inRepository)) << "run manylight-scenes -o scenes";
        }
}

TEST_F(WrittenSceneTest, UnwritableFoldersAreErrors) {
    fs::create_directories(folder_);
    writeTextFile(folder_ / "file", "");
    EXPECT_THROW(writeGeneratedScene(generateCube(), folder_ / "file"), Error);
}

}  // namespace
}  // namespace manylight
