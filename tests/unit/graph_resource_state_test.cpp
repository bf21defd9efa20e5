// Every kind of hazard, on the state of one resource.
#include "engine/graph/resource_state.h"

#include <gtest/gtest.h>

namespace manylight {
namespace {

constexpr auto kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
constexpr auto kGraphics = VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
constexpr auto kColorOutput = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
constexpr auto kTransfer = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
constexpr auto kStorageRead = VK_ACCESS_2_SHADER_STORAGE_READ_BIT;
constexpr auto kStorageWrite = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;

using Waits = std::optional<Dependency>;

Waits use(ResourceState& state, Access access) { return advance(state, access, ResourceKind::Buffer); }
Waits useImage(ResourceState& state, Access access) { return advance(state, access, ResourceKind::Image); }

TEST(GraphResourceState, FirstUseOfABufferNeedsNoBarrier) {
    ResourceState state;
    EXPECT_EQ(use(state, Access::ComputeStorageWrite), std::nullopt);
    ResourceState uploaded;
    EXPECT_EQ(use(uploaded, Access::VertexBuffer), std::nullopt);
}

TEST(GraphResourceState, FirstUseOfAnImageChangesTheLayoutAndWaitsForNothing) {
    ResourceState state;
    EXPECT_EQ(useImage(state, Access::ComputeStorageWrite),
              (Dependency{{}, {kCompute, kStorageWrite}, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL}));
}

TEST(GraphResourceState, ReadAfterWriteMakesTheWriteVisible) {
    ResourceState state;
    use(state, Access::ComputeStorageWrite);
    EXPECT_EQ(use(state, Access::ComputeStorageRead),
              (Dependency{{kCompute, kStorageWrite}, {kCompute, kStorageRead}}));
}

TEST(GraphResourceState, SecondReadOfTheSameKindNeedsNoBarrier) {
    ResourceState state;
    use(state, Access::ComputeStorageWrite);
    use(state, Access::ComputeStorageRead);
    EXPECT_EQ(use(state, Access::ComputeStorageRead), std::nullopt);
}

TEST(GraphResourceState, SecondReaderInANewStageWaitsForTheWriteToo) {
    ResourceState state;
    use(state, Access::ComputeStorageWrite);
    use(state, Access::ComputeStorageRead);
    EXPECT_EQ(use(state, Access::GraphicsStorageRead),
              (Dependency{{kCompute, kStorageWrite}, {kGraphics, kStorageRead}}));
    EXPECT_EQ(use(state, Access::ComputeStorageRead), std::nullopt);
    EXPECT_EQ(use(state, Access::GraphicsStorageRead), std::nullopt);
}

TEST(GraphResourceState, VisibilityOfTwoReadersDoesNotMixTheirStagesAndAccesses) {
    ResourceState state;
    use(state, Access::ComputeStorageWrite);
    use(state, Access::ComputeUniform);
    use(state, Access::GraphicsStorageRead);
    EXPECT_EQ(use(state, Access::ComputeStorageRead),
              (Dependency{{kCompute, kStorageWrite}, {kCompute, kStorageRead}}));
}

TEST(GraphResourceState, WriteAfterReadWaitsForEveryReaderAndMovesNoMemory) {
    ResourceState state;
    use(state, Access::ComputeStorageWrite);
    use(state, Access::ComputeStorageRead);
    use(state, Access::GraphicsStorageRead);
    EXPECT_EQ(use(state, Access::TransferWrite),
              (Dependency{{kCompute | kGraphics, 0}, {kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT}}));
}

TEST(GraphResourceState, WriteAfterAReadThatWaitedForNothingStillWaitsForTheReader) {
    ResourceState uploaded;
    use(uploaded, Access::ComputeTexelRead);
    EXPECT_EQ(use(uploaded, Access::TransferWrite),
              (Dependency{{kCompute, 0}, {kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT}}));
}

TEST(GraphResourceState, ReaderAfterAWriteAfterAReadSeesTheNewWrite) {
    ResourceState state;
    use(state, Access::ComputeStorageWrite);
    use(state, Access::ComputeStorageRead);
    use(state, Access::TransferWrite);
    EXPECT_EQ(use(state, Access::ComputeStorageRead),
              (Dependency{{kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT}, {kCompute, kStorageRead}}));
}

TEST(GraphResourceState, WriteAfterAWriteForgetsTheReadersBeforeIt) {
    ResourceState state;
    use(state, Access::GraphicsStorageRead);
    use(state, Access::ComputeStorageWrite);
    EXPECT_EQ(use(state, Access::TransferWrite),
              (Dependency{{kCompute, kStorageWrite}, {kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT}}));
}

TEST(GraphResourceState, WriteAfterWriteInTheSameStageWaits) {
    ResourceState state;
    use(state, Access::ComputeStorageWrite);
    EXPECT_EQ(use(state, Access::ComputeStorageReadWrite),
              (Dependency{{kCompute, kStorageWrite}, {kCompute, kStorageRead | kStorageWrite}}));
    EXPECT_EQ(use(state, Access::ComputeStorageWrite),
              (Dependency{{kCompute, kStorageWrite}, {kCompute, kStorageWrite}}));
}

TEST(GraphResourceState, AttachmentsWrittenTwiceWaitForTheFirstWrite) {
    ResourceState state;
    useImage(state, Access::ColorWrite);
    const auto second = useImage(state, Access::ColorBlend);
    ASSERT_TRUE(second.has_value());
    EXPECT_EQ(second->before, (SyncScope{kColorOutput, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT}));
    EXPECT_EQ(second->after, (SyncScope{kColorOutput, VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT |
                                                          VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT}));
    EXPECT_EQ(second->oldLayout, second->newLayout);
}

TEST(GraphResourceState, ReadThatChangesTheLayoutMovesTheWrite) {
    ResourceState state;
    useImage(state, Access::ColorWrite);
    EXPECT_EQ(useImage(state, Access::ComputeStorageRead),
              (Dependency{{kColorOutput, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT},
                          {kCompute, kStorageRead},
                          VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                          VK_IMAGE_LAYOUT_GENERAL}));
}

// The second reader must follow the layout change, which ended before the first reader's stage began.
TEST(GraphResourceState, ReaderAfterALayoutChangeChainsToItsBarrier) {
    ResourceState state;
    useImage(state, Access::ColorWrite);
    useImage(state, Access::ComputeStorageRead);
    EXPECT_EQ(useImage(state, Access::GraphicsStorageRead),
              (Dependency{{kCompute, 0}, {kGraphics, kStorageRead}, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_GENERAL}));
    EXPECT_EQ(useImage(state, Access::ComputeStorageRead), std::nullopt);
}

TEST(GraphResourceState, ReadThatChangesTheLayoutWaitsForEarlierReaders) {
    ResourceState state;
    useImage(state, Access::ComputeStorageWrite);
    useImage(state, Access::ComputeStorageRead);
    useImage(state, Access::GraphicsStorageRead);
    EXPECT_EQ(useImage(state, Access::TransferRead), (Dependency{{kCompute | kGraphics, 0},
                                                                 {kTransfer, VK_ACCESS_2_TRANSFER_READ_BIT},
                                                                 VK_IMAGE_LAYOUT_GENERAL,
                                                                 VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL}));
}

TEST(GraphResourceState, DepthTestAfterDepthWriteChangesTheLayout) {
    ResourceState state;
    useImage(state, Access::DepthWrite);
    const auto test = useImage(state, Access::DepthRead);
    ASSERT_TRUE(test.has_value());
    EXPECT_EQ(test->before.access, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT);
    EXPECT_EQ(test->after.access, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT);
    EXPECT_EQ(test->newLayout, VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL);
    EXPECT_EQ(useImage(state, Access::DepthRead), std::nullopt);
}

TEST(GraphResourceState, UnknownPastWaitsForEverything) {
    ResourceState state = unknownState();
    const auto first = use(state, Access::ComputeStorageWrite);
    ASSERT_TRUE(first.has_value());
    EXPECT_EQ(first->before, (SyncScope{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT}));
}

TEST(GraphResourceState, PresentingWaitsForTheWriteAndChangesTheLayout) {
    ResourceState state;
    useImage(state, Access::ColorWrite);
    const auto present = useImage(state, Access::Present);
    ASSERT_TRUE(present.has_value());
    EXPECT_EQ(present->before, (SyncScope{kColorOutput, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT}));
    EXPECT_EQ(present->newLayout, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR);
}

}  // namespace
}  // namespace manylight
