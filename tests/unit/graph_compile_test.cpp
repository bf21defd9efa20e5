// Culling, lifetimes, derived usage, shared memory and barriers of whole graphs, without a device.
#include "engine/graph/compile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace manylight {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr ImageDesc kImage{VK_FORMAT_R32G32B32A32_SFLOAT, 64, 32};
constexpr BufferDesc kBuffer{256, VK_FORMAT_R32G32B32A32_SFLOAT};
constexpr SyncScope kEverything{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT};

std::vector<uint32_t> livePasses(const CompiledGraph& compiled) {
    std::vector<uint32_t> passes;
    for (const LivePass& live : compiled.passes) passes.push_back(live.pass);
    return passes;
}

ImageHandle addFill(FrameGraph& graph, const char* name) {
    return graph.addPass(name).write(graph.createImage(name, kImage), Access::ComputeStorageWrite);
}

ImageHandle addFilter(FrameGraph& graph, const std::string& name, ImageHandle source) {
    const auto target = graph.createImage(name, kImage);
    return graph.addPass(name).read(source, Access::ComputeStorageRead).write(target, Access::ComputeStorageWrite);
}

TEST(GraphCulling, OnlyWhatTheResultNeedsRuns) {
    FrameGraph graph;
    const auto albedo = addFill(graph, "albedo");
    addFill(graph, "unread");
    addFilter(graph, "readByNobody", albedo);
    graph.keep(addFilter(graph, "result", albedo));
    const CompiledGraph compiled = graph.compile();
    EXPECT_THAT(livePasses(compiled), ElementsAre(0, 3));
    EXPECT_THAT(compiled.culled, ElementsAre(1, 2));
}

TEST(GraphCulling, NothingKeptNothingRuns) {
    FrameGraph graph;
    addFilter(graph, "b", addFill(graph, "a"));
    const CompiledGraph compiled = graph.compile();
    EXPECT_THAT(compiled.passes, IsEmpty());
    EXPECT_THAT(compiled.culled, ElementsAre(0, 1));
    EXPECT_THAT(compiled.slots, IsEmpty());
}

TEST(GraphCulling, PureWriteMakesAnUnreadEarlierWriterUseless) {
    FrameGraph graph;
    const auto vpls = graph.importBuffer("vpls", kBuffer, {}, nullptr);
    const auto first = graph.addPass("first").write(vpls, Access::ComputeStorageWrite);
    graph.keep(graph.addPass("second").write(first, Access::ComputeStorageWrite));
    EXPECT_THAT(livePasses(graph.compile()), ElementsAre(1));
}

TEST(GraphCulling, ReadWriteBlendAndLoadNeedTheEarlierWriter) {
    FrameGraph graph;
    auto image = graph.addPass("clear").write(graph.createImage("hdr", kImage), Access::ColorWrite, VkClearValue{});
    image = graph.addPass("load").write(image, Access::ColorWrite);
    image = graph.addPass("blend").write(image, Access::ColorBlend);
    graph.keep(graph.addPass("accumulate").write(image, Access::ComputeStorageReadWrite));
    EXPECT_THAT(livePasses(graph.compile()), ElementsAre(0, 1, 2, 3));
}

TEST(GraphCulling, ClearedAttachmentDoesNotNeedTheEarlierWriter) {
    FrameGraph graph;
    const auto drawn =
        graph.addPass("draw").write(graph.createImage("hdr", kImage), Access::ColorWrite, VkClearValue{});
    graph.keep(graph.addPass("again").write(drawn, Access::ColorBlend, VkClearValue{}));
    EXPECT_THAT(livePasses(graph.compile()), ElementsAre(1));
}

TEST(GraphCulling, HiddenEffectKeepsThePassAndWhatItReads) {
    FrameGraph graph;
    const auto albedo = addFill(graph, "albedo");
    auto print = graph.addPass("print");
    print.read(albedo, Access::ComputeStorageRead).keep("prints through the validation layer");
    EXPECT_THAT(livePasses(graph.compile()), ElementsAre(0, 1));
    EXPECT_EQ(graph.passes()[1].keepReason, "prints through the validation layer");
}

TEST(GraphUsage, CulledPassesDoNotCount) {
    FrameGraph graph;
    const auto albedo = addFill(graph, "albedo");
    graph.addPass("culledCopy").read(albedo, Access::TransferRead);
    const auto scene = graph.importBuffer("scene", kBuffer, {}, nullptr);
    graph.addPass("culledRead").read(scene, Access::ComputeTexelRead);
    auto result = graph.addPass("result");
    result.read(albedo, Access::ComputeStorageRead).read(scene, Access::ComputeUniform);
    graph.keep(result.write(graph.createImage("result", kImage), Access::ColorWrite, VkClearValue{}));
    const CompiledGraph compiled = graph.compile();
    EXPECT_EQ(compiled.resources[albedo.resource].imageUsage, VkImageUsageFlags{VK_IMAGE_USAGE_STORAGE_BIT});
    EXPECT_EQ(compiled.resources[albedo.resource].lastPass, 1u);
    EXPECT_EQ(compiled.resources[scene.resource].bufferUsage, VkBufferUsageFlags{VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT});
    EXPECT_EQ(compiled.resources[scene.resource].imageUsage, 0u);
}

TEST(GraphUsage, ResourceOfCulledPassesOnlyGetsNoMemory) {
    FrameGraph graph;
    const auto unread = addFill(graph, "unread");
    graph.keep(addFill(graph, "result"));
    const CompiledGraph compiled = graph.compile();
    EXPECT_EQ(compiled.resources[unread.resource].firstPass, kNoIndex);
    EXPECT_EQ(compiled.resources[unread.resource].slot, kNoIndex);
    EXPECT_EQ(compiled.slots.size(), 1u);
}

TEST(GraphSlots, ChainOfAHundredPassesNeedsTwoImages) {
    FrameGraph graph;
    auto image = addFill(graph, "0");
    for (int i = 1; i < 100; ++i) image = addFilter(graph, std::to_string(i), image);
    graph.keep(image);
    const CompiledGraph compiled = graph.compile();
    EXPECT_EQ(compiled.passes.size(), 100u);
    EXPECT_EQ(compiled.slots.size(), 2u);
    EXPECT_EQ(compiled.passes[0].barriers.size(), 1u);
    for (size_t i = 1; i < 100; ++i) EXPECT_EQ(compiled.passes[i].barriers.size(), 2u) << i;
}

// 0 -> 1 -> 2 -> 3: image 2 takes the memory of image 0, which pass 1 was the last to read.
TEST(GraphSlots, RecycledImageWaitsForItsLastOwnerAndDropsItsContent) {
    FrameGraph graph;
    const auto first = addFill(graph, "0");
    const auto third = addFilter(graph, "2", addFilter(graph, "1", first));
    graph.keep(addFilter(graph, "3", third));
    const CompiledGraph compiled = graph.compile();
    ASSERT_EQ(compiled.resources[first.resource].slot, compiled.resources[third.resource].slot);
    ASSERT_EQ(compiled.passes[2].barriers.size(), 2u);
    const Barrier& reuse = compiled.passes[2].barriers[1];
    EXPECT_EQ(reuse.resource, third.resource);
    EXPECT_EQ(reuse.dependency.before, (SyncScope{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, 0}));
    EXPECT_EQ(reuse.dependency.oldLayout, VK_IMAGE_LAYOUT_UNDEFINED);
    EXPECT_EQ(reuse.dependency.newLayout, VK_IMAGE_LAYOUT_GENERAL);
}

TEST(GraphSlots, OnlyEqualDescriptionsShare) {
    FrameGraph graph;
    const auto source = addFill(graph, "source");
    const auto middle = addFilter(graph, "middle", source);
    const auto small = graph.createImage("small", {kImage.format, 32, 32});
    graph.keep(
        graph.addPass("shrink").read(middle, Access::ComputeStorageRead).write(small, Access::ComputeStorageWrite));
    EXPECT_EQ(graph.compile().slots.size(), 3u);
}

TEST(GraphSlots, UsageOfASlotIsThatOfAllItsOwners) {
    FrameGraph graph;
    const auto first = addFill(graph, "0");
    const auto second = addFilter(graph, "1", first);
    auto draw = graph.addPass("draw");
    draw.read(second, Access::ComputeStorageRead);
    const auto drawn = draw.write(graph.createImage("2", kImage), Access::ColorWrite, VkClearValue{});
    graph.keep(drawn);
    const CompiledGraph compiled = graph.compile();
    const uint32_t slot = compiled.resources[first.resource].slot;
    ASSERT_EQ(slot, compiled.resources[drawn.resource].slot);
    EXPECT_EQ(compiled.slots[slot].imageUsage,
              VkImageUsageFlags{VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT});
}

TEST(GraphSlots, KeptTransientIsNotRecycledBeforeTheFrameEnds) {
    FrameGraph graph;
    const auto early = addFill(graph, "early");
    graph.keep(early);
    const auto late = addFilter(graph, "c", addFilter(graph, "b", addFill(graph, "a")));
    graph.keep(late);
    const CompiledGraph compiled = graph.compile();
    EXPECT_EQ(compiled.resources[early.resource].lastPass, 3u);
    for (uint32_t r = 1; r < compiled.resources.size(); ++r) {
        EXPECT_NE(compiled.resources[r].slot, compiled.resources[early.resource].slot);
    }
}

TEST(GraphSlots, FirstUseInAFrameWaitsForThePreviousFrame) {
    FrameGraph graph;
    graph.keep(addFill(graph, "image"));
    const CompiledGraph unknown = graph.compile();
    ASSERT_EQ(unknown.passes[0].barriers.size(), 1u);
    EXPECT_EQ(unknown.passes[0].barriers[0].dependency.before, kEverything);

    const ResourceState left = unknown.slots[0].finalState;
    const CompiledGraph next = graph.compile([&](const PhysicalSlot&) { return left; });
    ASSERT_EQ(next.passes[0].barriers.size(), 1u);
    EXPECT_EQ(next.passes[0].barriers[0].dependency.before,
              (SyncScope{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT}));
    EXPECT_EQ(next.passes[0].barriers[0].dependency.oldLayout, VK_IMAGE_LAYOUT_UNDEFINED);
}

TEST(GraphSlots, StatesAreAskedForOncePerSlotWithItsUsage) {
    FrameGraph graph;
    graph.keep(addFilter(graph, "c", addFilter(graph, "b", addFill(graph, "a"))));
    std::vector<VkImageUsageFlags> asked;
    graph.compile([&](const PhysicalSlot& slot) {
        asked.push_back(slot.imageUsage);
        return ResourceState{};
    });
    EXPECT_THAT(asked, ElementsAre(VK_IMAGE_USAGE_STORAGE_BIT, VK_IMAGE_USAGE_STORAGE_BIT));
}

TEST(GraphBarriers, ImportedResourceContinuesFromItsStateAndReportsTheLast) {
    FrameGraph graph;
    ResourceState lastFrame;
    advance(lastFrame, Access::ComputeStorageWrite, ResourceKind::Image);
    const auto history = graph.importImage("history", kImage, lastFrame, nullptr);
    auto blend = graph.addPass("blend");
    blend.read(history, Access::GraphicsStorageRead);
    graph.keep(blend.write(graph.createImage("result", kImage), Access::ColorWrite, VkClearValue{}));
    const CompiledGraph compiled = graph.compile();
    ASSERT_EQ(compiled.passes[0].barriers.size(), 2u);
    const Dependency expected = *advance(lastFrame, Access::GraphicsStorageRead, ResourceKind::Image);
    EXPECT_EQ(compiled.passes[0].barriers[0].dependency, expected);
    EXPECT_EQ(compiled.resources[history.resource].finalState, lastFrame);
}

TEST(GraphBarriers, CulledPassesLeaveNoTraceInTheBarriers) {
    FrameGraph graph;
    const auto scene = graph.importBuffer("scene", kBuffer, {}, nullptr);
    graph.addPass("culled").read(scene, Access::TransferRead);
    graph.keep(graph.addPass("update").write(scene, Access::ComputeStorageWrite));
    const CompiledGraph compiled = graph.compile();
    ASSERT_EQ(compiled.passes.size(), 1u);
    EXPECT_THAT(compiled.passes[0].barriers, IsEmpty());
}

TEST(GraphBarriers, ExternalObjectIsHandedThrough) {
    FrameGraph graph;
    int object = 0;
    const auto scene = graph.importBuffer("scene", kBuffer, {}, &object);
    EXPECT_EQ(graph.resources()[scene.resource].external, &object);
}

}  // namespace
}  // namespace manylight
