// The three dumps of a small deferred graph; the text is a reviewed snapshot.
#include "engine/graph/dump.h"
#include "engine/graph/flag_names.h"
#include "tests/unit/graph_snapshot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace manylight {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr uint32_t kWidth = 640;
constexpr uint32_t kHeight = 360;
constexpr ImageDesc kHdr{VK_FORMAT_R32G32B32A32_SFLOAT, kWidth, kHeight};

struct GBuffer {
    ImageHandle albedo, normal, depth;
};

GBuffer addGBuffer(FrameGraph& graph, BufferHandle vertices) {
    auto pass = graph.addPass("gbuffer");
    pass.read(vertices, Access::VertexBuffer);
    const auto albedo = graph.createImage("albedo", {VK_FORMAT_R8G8B8A8_UNORM, kWidth, kHeight});
    const auto normal = graph.createImage("normal", kHdr);
    const auto depth = graph.createImage("depth", {VK_FORMAT_D32_SFLOAT, kWidth, kHeight});
    return {pass.write(albedo, Access::ColorWrite, VkClearValue{}),
            pass.write(normal, Access::ColorWrite, VkClearValue{}),
            pass.write(depth, Access::DepthWrite, VkClearValue{})};
}

/// Emission, G-buffer, two lighting passes, a debug view nobody asked for, tone map and read-back.
FrameGraph deferredGraph() {
    FrameGraph graph;
    const auto bvh = graph.importBuffer("bvh", {65536, VK_FORMAT_R32G32B32A32_SFLOAT}, {}, nullptr);
    const auto vertices = graph.importBuffer("vertices", {4096}, {}, nullptr);
    const auto readback = graph.importBuffer("readback", {kWidth * kHeight * 16}, {}, nullptr);

    auto emission = graph.addPass("vpl_emission");
    emission.read(bvh, Access::ComputeTexelRead, 0);
    const auto vpls = emission.write(graph.createBuffer("vpls", {48 * 1024}), Access::ComputeStorageWrite, 1);

    const GBuffer surface = addGBuffer(graph, vertices);

    auto direct = graph.addPass("direct_light");
    direct.read(surface.albedo, Access::ComputeStorageRead, 0).read(surface.normal, Access::ComputeStorageRead, 1);
    direct.read(bvh, Access::ComputeTexelRead, 2);
    auto hdr = direct.write(graph.createImage("hdr", kHdr), Access::ComputeStorageWrite, 3);

    auto indirect = graph.addPass("vpl_light");
    indirect.read(surface.albedo, Access::ComputeStorageRead, 0).read(surface.normal, Access::ComputeStorageRead, 1);
    indirect.read(bvh, Access::ComputeTexelRead, 2).read(vpls, Access::ComputeStorageRead, 4);
    hdr = indirect.write(hdr, Access::ComputeStorageReadWrite, 3);

    auto markers = graph.addPass("show_vpls");
    markers.read(vpls, Access::GraphicsStorageRead, 0).read(surface.depth, Access::DepthRead);
    hdr = markers.write(hdr, Access::ColorBlend);

    graph.addPass("show_normal")
        .read(surface.normal, Access::ComputeStorageRead, 0)
        .write(graph.createImage("normal_view", kHdr), Access::ComputeStorageWrite, 1);

    auto tonemap = graph.addPass("tonemap");
    tonemap.read(hdr, Access::ComputeStorageRead, 0);
    const auto ldr = tonemap.write(graph.createImage("ldr", kHdr), Access::ComputeStorageWrite, 1);

    const auto copied =
        graph.addPass("readback").read(ldr, Access::TransferRead).write(readback, Access::TransferWrite);
    graph.addPass("to_host").read(copied, Access::HostRead).keep("the host reads the buffer after the frame");
    return graph;
}

TEST(GraphDump, DeferredGraphMatchesTheReviewedText) {
    const FrameGraph graph = deferredGraph();
    expectSnapshot("example_deferred", toText(graph, graph.compile()));
}

TEST(GraphDump, JsonHasEveryPassResourceAndBarrier) {
    const FrameGraph graph = deferredGraph();
    const CompiledGraph compiled = graph.compile();
    const Json json = Json::parse(toJson(graph, compiled).dump());
    ASSERT_EQ(json["passes"].size(), graph.passes().size());
    EXPECT_EQ(json["resources"].size(), graph.resources().size());
    EXPECT_EQ(json["slots"].size(), compiled.slots.size());
    EXPECT_EQ(json["passes"][5]["name"], "show_normal");
    EXPECT_EQ(json["passes"][5]["culled"], true);
    EXPECT_EQ(json["passes"][8]["kept"], "the host reads the buffer after the frame");
    ASSERT_EQ(json["passes"][8]["barriers"].size(), 1u);
    EXPECT_EQ(json["passes"][8]["barriers"][0]["srcAccess"], "transferWrite");
    EXPECT_EQ(json["passes"][8]["barriers"][0]["dstStages"], "host");
    EXPECT_EQ(json["passes"][0]["uses"][1]["binding"], 1);
}

TEST(GraphDump, DotDrawsEveryPassAndDashesTheCulled) {
    const FrameGraph graph = deferredGraph();
    const std::string dot = toDot(graph, graph.compile());
    EXPECT_THAT(dot, HasSubstr("p5 [shape=box, style=dashed, label=\"show_normal\"];"));
    EXPECT_THAT(dot, HasSubstr("p0 [shape=box, style=solid, label=\"vpl_emission\\nbarriers: 1\"];"));
    EXPECT_THAT(dot, HasSubstr("r0_0 -> p0 [label=\"ComputeTexelRead\"];"));
    EXPECT_THAT(dot, HasSubstr("p0 -> r3_1 [label=\"ComputeStorageWrite\"];"));
    EXPECT_THAT(dot, Not(HasSubstr("r3_0"))) << "a transient has no content before its first write";
}

TEST(GraphDump, NamesJoinAndUnknownBitsStayVisible) {
    EXPECT_EQ(stageNames(VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT),
              "vertex|fragment");
    EXPECT_EQ(accessNames(0), "none");
    EXPECT_EQ(imageUsageNames(VK_IMAGE_USAGE_STORAGE_BIT | 0x40000000u), "storage|0x40000000");
    EXPECT_EQ(formatName(VK_FORMAT_R5G6B5_UNORM_PACK16), "4");
}

}  // namespace
}  // namespace manylight
