#include "engine/core/check.h"
#include "engine/core/file.h"
#include "tests/fuzz/glb_mutator.h"
#include "tests/fuzz/readers.h"
#include "tests/fuzz/scene_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace manylight::fuzz {
namespace {

namespace fs = std::filesystem;

const fs::path kCorpus = fs::path(MANYLIGHT_SOURCE_DIR) / "tests" / "fuzz" / "corpus";

std::vector<fs::path> filesOf(std::string_view reader) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(kCorpus / reader)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

class FuzzCorpus : public ::testing::TestWithParam<std::string_view> {};

TEST_P(FuzzCorpus, EveryFileEndsInASceneOrInAnError) {
    size_t readCount = 0;
    for (const fs::path& file : filesOf(GetParam())) {
        try {
            const Outcome outcome = readAndCheck(GetParam(), readTextFile(file));
            EXPECT_NE(outcome.error.empty(), outcome.summary.empty()) << file;
            readCount += outcome.error.empty();
        } catch (const std::exception& exception) {
            ADD_FAILURE() << file << ": " << exception.what();
        }
    }
    EXPECT_GE(readCount, 2u) << "no seed gets past the checks";
}

INSTANTIATE_TEST_SUITE_P(Readers, FuzzCorpus, ::testing::Values("obj", "mtl", "gltf", "glb", "sidecar", "image", "exr"),
                         [](const auto& reader) { return std::string(reader.param); });

TEST(FuzzReaders, HaveAFolderOfTheCorpusEach) {
    size_t folders = 0;
    for (const auto& entry : fs::directory_iterator(kCorpus)) folders += entry.is_directory();
    EXPECT_EQ(folders, readers().size());
    for (const Reader& reader : readers()) EXPECT_TRUE(fs::is_directory(kCorpus / reader.name)) << reader.name;
}

/// A triangle that checkScene() has nothing against.
Scene soundScene() {
    Scene scene;
    scene.vertices = {{.position = {0, 0, 0}}, {.position = {1, 0, 0}}, {.position = {0, 1, 0}}};
    scene.triangles = {{.vertex = {0, 1, 2}, .material = 0}};
    scene.materials = {{.name = "grey"}};
    scene.lights = {{.type = LightType::Spot, .name = "spot"}};
    scene.cameras.resize(1);
    scene.boundsMax = {1, 1, 0};
    return scene;
}

TEST(SceneCheck, FindsWhatNoRendererCanUse) {
    EXPECT_NO_THROW(checkScene(soundScene()));
    const auto isFound = [](auto breakIt) {
        Scene scene = soundScene();
        breakIt(scene);
        try {
            checkScene(scene);
        } catch (const BugError&) {
            return true;
        }
        return false;
    };
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(isFound([](Scene& scene) { scene.triangles[0].vertex[2] = 3; }));
    EXPECT_TRUE(isFound([](Scene& scene) { scene.triangles[0].material = 1; }));
    EXPECT_TRUE(isFound([](Scene& scene) { scene.vertices[0].position.x = kNaN; }));
    EXPECT_TRUE(isFound([](Scene& scene) { scene.vertices[0].normal = {0, 0, 2}; }));
    EXPECT_TRUE(isFound([](Scene& scene) { scene.vertices[0].uv.y = kNaN; }));
    EXPECT_TRUE(isFound([](Scene& scene) { scene.boundsMax = {4, 4, 0}; }));
    EXPECT_TRUE(isFound([](Scene& scene) { scene.materials[0].albedo.y = 1.5f; }));
    EXPECT_TRUE(isFound([](Scene& scene) { scene.materials[0].albedoTexture.texture = 0; }));
    EXPECT_TRUE(isFound([](Scene& scene) { scene.lights[0].emission.z = -1.0f; }));
    EXPECT_TRUE(isFound([](Scene& scene) { scene.lights[0].cosCutoff = 2.0f; }));
    EXPECT_TRUE(isFound([](Scene& scene) { scene.cameras[0].up = scene.cameras[0].forward; }));
    EXPECT_TRUE(isFound([](Scene& scene) { scene.cameras.clear(); }));
}

/// Puts a blank in front, as a mutation may.
size_t prependBlank(uint8_t* data, size_t size, size_t mostBytes) {
    if (size == mostBytes) return size;
    std::copy_backward(data, data + size, data + size + 1);
    data[0] = ' ';
    return size + 1;
}

TEST(GlbMutator, KeepsTheLengthsRight) {
    const std::string glb = readTextFile(kCorpus / "glb" / "textured.glb");
    size_t changed = 0;
    for (unsigned int seed = 1; seed < 6; ++seed) {
        std::string bytes = glb;
        bytes.resize(glb.size() + 100);
        bytes.resize(mutateGlb(reinterpret_cast<uint8_t*>(bytes.data()), glb.size(), bytes.size(), seed, prependBlank));
        changed += bytes != glb;
        EXPECT_EQ(readAndCheck("glb", bytes).error, "") << seed;
    }
    EXPECT_EQ(changed, 5u);
}

}  // namespace
}  // namespace manylight::fuzz
