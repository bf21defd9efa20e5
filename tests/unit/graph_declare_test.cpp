// Misuse of the graph throws and names the pass and the resource.
#include "engine/core/error.h"
#include "engine/graph/compile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace manylight {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr ImageDesc kImage{VK_FORMAT_R32G32B32A32_SFLOAT, 64, 32};
constexpr BufferDesc kBuffer{256};

/// The message of the BugError that `action` throws; empty if it throws none.
template <typename Action>
std::string bugMessage(Action action) {
    try {
        action();
    } catch (const BugError& bug) {
        return bug.what();
    }
    return {};
}

TEST(GraphDeclare, EachWriteGivesANewVersion) {
    FrameGraph graph;
    const auto empty = graph.createBuffer("vpls", kBuffer);
    const auto first = graph.addPass("emit").write(empty, Access::ComputeStorageWrite);
    const auto second = graph.addPass("compact").write(first, Access::ComputeStorageReadWrite);
    EXPECT_EQ(first.resource, empty.resource);
    EXPECT_EQ(first.version, 1u);
    EXPECT_EQ(second.version, 2u);
}

TEST(GraphDeclare, StaleHandleThrows) {
    FrameGraph graph;
    const auto empty = graph.createBuffer("vpls", kBuffer);
    const auto first = graph.addPass("emit").write(empty, Access::ComputeStorageWrite);
    graph.addPass("compact").write(first, Access::ComputeStorageReadWrite);
    auto shade = graph.addPass("shade");
    const auto expected = AllOf(HasSubstr("pass 'shade'"), HasSubstr("stale handle to 'vpls'"));
    EXPECT_THAT(bugMessage([&] { shade.read(first, Access::ComputeStorageRead); }), expected);
    EXPECT_THAT(bugMessage([&] { shade.write(first, Access::ComputeStorageWrite); }), expected);
    EXPECT_THAT(bugMessage([&] { graph.keep(first); }), HasSubstr("stale handle to 'vpls'"));
}

TEST(GraphDeclare, DoubleAccessThrows) {
    FrameGraph graph;
    const auto vpls = graph.importBuffer("vpls", kBuffer, {}, nullptr);
    auto pass = graph.addPass("shade");
    pass.read(vpls, Access::ComputeStorageRead);
    const auto expected = AllOf(HasSubstr("pass 'shade'"), HasSubstr("double access to 'vpls'"));
    EXPECT_THAT(bugMessage([&] { pass.read(vpls, Access::ComputeUniform); }), expected);
    EXPECT_THAT(bugMessage([&] { pass.write(vpls, Access::ComputeStorageWrite); }), expected);
}

TEST(GraphDeclare, ReadBeforeAnyWriteThrows) {
    FrameGraph graph;
    const auto albedo = graph.createImage("albedo", kImage);
    const auto fresh = graph.importImage("history", kImage, {}, nullptr);
    auto pass = graph.addPass("shade");
    const auto expected = AllOf(HasSubstr("pass 'shade'"), HasSubstr("'albedo' is read before"));
    EXPECT_THAT(bugMessage([&] { pass.read(albedo, Access::ComputeStorageRead); }), expected);
    EXPECT_THAT(bugMessage([&] { pass.write(albedo, Access::ComputeStorageReadWrite); }), expected);
    EXPECT_THAT(bugMessage([&] { pass.write(albedo, Access::ColorWrite); }), expected) << "loaded, not cleared";
    EXPECT_THAT(bugMessage([&] { pass.read(fresh, Access::ComputeStorageRead); }), HasSubstr("'history' is read"));
    EXPECT_THAT(bugMessage([&] { graph.keep(albedo); }), HasSubstr("'albedo' was never written"));
    EXPECT_NO_THROW(pass.write(albedo, Access::ColorWrite, VkClearValue{}));
}

TEST(GraphDeclare, ImportedContentCanBeReadAtOnce) {
    FrameGraph graph;
    ResourceState lastFrame;
    lastFrame.layout = VK_IMAGE_LAYOUT_GENERAL;
    const auto history = graph.importImage("history", kImage, lastFrame, nullptr);
    EXPECT_NO_THROW(graph.addPass("blend").read(history, Access::ComputeStorageRead));
}

TEST(GraphDeclare, UnknownHandleThrows) {
    FrameGraph graph;
    graph.createImage("albedo", kImage);
    auto pass = graph.addPass("shade");
    const auto expected = AllOf(HasSubstr("pass 'shade'"), HasSubstr("unknown"));
    EXPECT_THAT(bugMessage([&] { pass.read(ImageHandle{}, Access::ComputeStorageRead); }), expected);
    EXPECT_THAT(bugMessage([&] { pass.write(BufferHandle{}, Access::ComputeStorageWrite); }), expected);
    EXPECT_THAT(bugMessage([&] {
                    pass.write(BufferHandle{0, 0}, Access::ComputeStorageWrite);
                }),
                AllOf(expected, HasSubstr("'albedo'")))
        << "an image behind a buffer handle";
}

TEST(GraphDeclare, AccessInTheWrongDirectionThrows) {
    FrameGraph graph;
    const auto vpls = graph.importBuffer("vpls", kBuffer, {}, nullptr);
    auto pass = graph.addPass("emit");
    EXPECT_THAT(bugMessage([&] { pass.read(vpls, Access::ComputeStorageWrite); }),
                AllOf(HasSubstr("'emit'"), HasSubstr("'vpls'"), HasSubstr("ComputeStorageWrite given to read()")));
    EXPECT_THAT(bugMessage([&] { pass.write(vpls, Access::ComputeStorageRead); }),
                AllOf(HasSubstr("'emit'"), HasSubstr("'vpls'"), HasSubstr("ComputeStorageRead given to write()")));
}

TEST(GraphDeclare, AccessThatDoesNotFitTheResourceThrows) {
    FrameGraph graph;
    const auto vpls = graph.importBuffer("vpls", kBuffer, {}, nullptr);
    const auto albedo = graph.createImage("albedo", kImage);
    auto pass = graph.addPass("p");
    EXPECT_THAT(bugMessage([&] { pass.write(vpls, Access::ColorWrite); }), HasSubstr("not an access to buffers"));
    EXPECT_THAT(bugMessage([&] { pass.read(albedo, Access::VertexBuffer); }), HasSubstr("not an access to images"));
    EXPECT_THAT(bugMessage([&] { pass.read(vpls, Access::ComputeTexelRead); }), HasSubstr("no texel format"));
    EXPECT_THAT(bugMessage([&] { pass.read(vpls, Access::VertexBuffer, 3); }), HasSubstr("takes no binding"));
    EXPECT_THAT(bugMessage([&] { pass.write(albedo, Access::TransferWrite, VkClearValue{}); }),
                HasSubstr("only attachments are cleared"));
}

TEST(GraphDeclare, TwoResourcesAtOneBindingThrow) {
    FrameGraph graph;
    const auto vpls = graph.importBuffer("vpls", kBuffer, {}, nullptr);
    const auto lights = graph.importBuffer("lights", kBuffer, {}, nullptr);
    auto pass = graph.addPass("shade");
    pass.read(vpls, Access::ComputeStorageRead, 2);
    EXPECT_THAT(bugMessage([&] { pass.read(lights, Access::ComputeStorageRead, 2); }),
                AllOf(HasSubstr("'shade'"), HasSubstr("'vpls' and 'lights' share binding 2")));
    EXPECT_NO_THROW(pass.read(lights, Access::ComputeStorageRead, 3));
}

TEST(GraphDeclare, OverwritingAResultThrows) {
    FrameGraph graph;
    const auto result = graph.addPass("tonemap").write(graph.createImage("ldr", kImage), Access::ComputeStorageWrite);
    graph.keep(result);
    EXPECT_THAT(bugMessage([&] { graph.addPass("overlay").write(result, Access::ComputeStorageReadWrite); }),
                AllOf(HasSubstr("'overlay'"), HasSubstr("overwrites 'ldr', which is kept")));
}

TEST(GraphDeclare, ExtendingAnEarlierPassThrows) {
    FrameGraph graph;
    const auto vpls = graph.importBuffer("vpls", kBuffer, {}, nullptr);
    auto first = graph.addPass("first");
    graph.addPass("second");
    EXPECT_THAT(bugMessage([&] { first.read(vpls, Access::ComputeStorageRead); }), HasSubstr("pass 'first'"));
}

TEST(GraphDeclare, HiddenEffectNeedsAReason) {
    FrameGraph graph;
    auto pass = graph.addPass("print");
    EXPECT_THAT(bugMessage([&] { pass.keep(""); }), AllOf(HasSubstr("'print'"), HasSubstr("without a reason")));
}

TEST(GraphDeclare, EmptyResourceThrows) {
    FrameGraph graph;
    EXPECT_THAT(bugMessage([&] { graph.createImage("albedo", {VK_FORMAT_R32_SFLOAT, 0, 1}); }), HasSubstr("'albedo'"));
    EXPECT_THAT(bugMessage([&] { graph.createImage("albedo", {VK_FORMAT_UNDEFINED, 1, 1}); }), HasSubstr("no format"));
    EXPECT_THAT(bugMessage([&] { graph.createBuffer("vpls", {0}); }), HasSubstr("'vpls'"));
}

}  // namespace
}  // namespace manylight
