// The access table: rows in the order of the enum and consistent in themselves.
#include "engine/core/error.h"
#include "engine/graph/access.h"

#include <gtest/gtest.h>

#include <bit>
#include <string>

namespace manylight {
namespace {

TEST(GraphAccess, RowsStandInTheOrderOfTheEnum) {
    EXPECT_STREQ(accessInfo(Access::ComputeUniform).name, "ComputeUniform");
    EXPECT_STREQ(accessInfo(Access::ComputeStorageReadWrite).name, "ComputeStorageReadWrite");
    EXPECT_STREQ(accessInfo(Access::GraphicsTexelRead).name, "GraphicsTexelRead");
    EXPECT_STREQ(accessInfo(Access::ColorBlend).name, "ColorBlend");
    EXPECT_STREQ(accessInfo(Access::DepthRead).name, "DepthRead");
    EXPECT_STREQ(accessInfo(Access::HostRead).name, "HostRead");
    EXPECT_STREQ(accessInfo(Access::Present).name, "Present");
    EXPECT_THROW(accessInfo(static_cast<Access>(kAccessCount)), BugError);
}

TEST(GraphAccess, EveryRowIsConsistent) {
    for (uint32_t i = 0; i < kAccessCount; ++i) {
        const AccessInfo& info = accessInfo(static_cast<Access>(i));
        SCOPED_TRACE(info.name);
        EXPECT_TRUE(info.reads || info.writes);
        EXPECT_EQ(info.writes, writeScope(info).access != 0);
        EXPECT_TRUE(fitsImages(info) || fitsBuffers(info));
        EXPECT_EQ(std::has_single_bit(info.imageUsage), fitsImages(info) && static_cast<Access>(i) != Access::Present);
        if (info.imageDescriptor != kNoDescriptor) {
            EXPECT_TRUE(fitsImages(info));
        }
        if (info.bufferDescriptor != kNoDescriptor) {
            EXPECT_TRUE(fitsBuffers(info));
        }
    }
}

TEST(GraphAccess, TexelReadsAreStorageTexelBuffersAndNeverImages) {
    for (const Access access : {Access::ComputeTexelRead, Access::GraphicsTexelRead}) {
        EXPECT_EQ(accessInfo(access).bufferDescriptor, VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER);
        EXPECT_EQ(accessInfo(access).bufferUsage, VkBufferUsageFlags{VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT});
        EXPECT_FALSE(fitsImages(accessInfo(access)));
    }
}

TEST(GraphAccess, RayQueriesReadAccelerationStructures) {
    for (const Access access : {Access::ComputeRayQuery, Access::GraphicsRayQuery}) {
        EXPECT_EQ(accessInfo(access).bufferDescriptor, VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR);
        EXPECT_FALSE(accessInfo(access).writes);
        EXPECT_FALSE(fitsImages(accessInfo(access)));
    }
}

TEST(GraphAccess, AttachmentsAndPresentationAreForImagesOnly) {
    for (const Access access : {Access::ColorWrite, Access::ColorBlend, Access::DepthWrite, Access::DepthRead}) {
        EXPECT_TRUE(isAttachment(accessInfo(access)));
        EXPECT_FALSE(fitsBuffers(accessInfo(access)));
    }
    EXPECT_FALSE(fitsBuffers(accessInfo(Access::Present)));
    EXPECT_FALSE(isAttachment(accessInfo(Access::ComputeStorageWrite)));
}

}  // namespace
}  // namespace manylight
