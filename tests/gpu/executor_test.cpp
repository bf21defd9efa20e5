// What the executor knows about passes that went wrong: where a device was, and who wrote numbers that are none.
#include "engine/core/error.h"
#include "engine/gpu/transfer.h"
#include "engine/graph/breadcrumbs.h"
#include "engine/graph/finite_check.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

#include <gmock/gmock.h>

#include <cstring>
#include <limits>

namespace manylight::test {
namespace {

using ::testing::HasSubstr;

class Executor : public GpuTest {};

DumpedImage dumpOf(const char* pass, const std::vector<float>& texels, VkFormat format) {
    const size_t components = format == VK_FORMAT_D32_SFLOAT ? 1 : 4;
    DumpedImage dump{pass, "image", format, static_cast<uint32_t>(texels.size() / components), 1, {}};
    dump.bytes.resize(texels.size() * sizeof(float));
    std::memcpy(dump.bytes.data(), texels.data(), dump.bytes.size());
    return dump;
}

TEST_F(Executor, MarksSayHowFarADeviceCame) {
    Breadcrumbs marks(device());
    marks.reset(3);
    EXPECT_EQ(marks.startedCount(), 0u);
    gpu::submitAndWait(device(), "leaving marks", [&](VkCommandBuffer commands) {
        marks.drop(commands, 0);
        marks.drop(commands, 1);
    });
    EXPECT_EQ(marks.startedCount(), 2u);
    marks.reset(100);
    EXPECT_EQ(marks.startedCount(), 0u);
}

TEST_F(Executor, NonFiniteTexelsAreFoundByTheirBits) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const float largest = std::numeric_limits<float>::max();
    const VkFormat rgba = VK_FORMAT_R32G32B32A32_SFLOAT;
    const std::vector<float> fine = {0, -0.0f, largest, -largest, 1e-45f, 1, 2, 3};
    EXPECT_FALSE(findNonFinite({dumpOf("fine", fine, rgba)}));
    for (const float bad : {nan, -nan, infinity, -infinity}) {
        std::vector<float> texels(12, 1.0f);
        texels[6] = bad;
        texels[7] = bad;
        texels[11] = bad;
        const auto found = findNonFinite({dumpOf("fine", fine, rgba), dumpOf("bad", texels, rgba)});
        ASSERT_TRUE(found);
        EXPECT_EQ(found->pass, "bad");
        EXPECT_EQ(found->texels, 2u);
        EXPECT_EQ(found->x, 1u);
        EXPECT_TRUE(findNonFinite({dumpOf("depth", {0.0f, bad}, VK_FORMAT_D32_SFLOAT)}));
        EXPECT_FALSE(findNonFinite({dumpOf("integers", texels, VK_FORMAT_R32G32B32A32_UINT)}));
    }
}

TEST_F(Executor, CheckedFramesAreTheSameAndABrokenLightIsNamed) {
    Scene scene = everyKindOfLight();
    RenderSettings settings = plainSettings();
    settings.castShadows = true;
    settings.vplCount = 16;
    settings.bounceCount = 2;
    for (const Technique technique :
         {Technique::Deferred, Technique::Forward, Technique::ForwardPrepass, Technique::PathTracer}) {
        settings.technique = technique;
        settings.checkFinite = false;
        const Image unchecked = render(scene, settings);
        settings.checkFinite = true;
        EXPECT_TRUE(sameBits(unchecked, render(scene, settings)));
    }
    scene.lights.front().emission = glm::vec3(std::numeric_limits<float>::infinity());
    settings.technique = Technique::Deferred;
    try {
        render(scene, settings);
        FAIL() << "an infinite light went unnoticed";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("that are not finite, the first at ("));
    }
}

}  // namespace
}  // namespace manylight::test
