#include "engine/gpu/specialise.h"
#include "engine/core/error.h"
#include "engine/gpu/shader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

namespace manylight::gpu {
namespace {

constexpr uint32_t kAlphaTested = 3;
constexpr uint32_t kInstanced = 9;

bool names(std::span<const uint32_t> words, std::string_view what) {
    const std::span<const std::byte> bytes = std::as_bytes(words);
    return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()).find(what) !=
           std::string_view::npos;
}

TEST(Specialise, LeavesOutWhatConstantsLeaveOut) {
    const std::span<const uint32_t> whole = shaderCode("compensation.comp");
    const std::vector<uint32_t> opaque = specialised(whole, {{kAlphaTested, 0}, {kInstanced, 0}});
    EXPECT_FALSE(names(opaque, "letsThrough("));
    EXPECT_FALSE(names(opaque, "occludedByInstances("));
    EXPECT_TRUE(names(opaque, "occludedInTree("));
    const std::vector<uint32_t> translucent = specialised(whole, {{kAlphaTested, 1}, {kInstanced, 0}});
    EXPECT_TRUE(names(translucent, "letsThrough("));
    EXPECT_FALSE(names(translucent, "occludedByInstances("));
    const std::vector<uint32_t> instanced = specialised(whole, {{kAlphaTested, 0}, {kInstanced, 2}});
    EXPECT_FALSE(names(instanced, "letsThrough("));
    EXPECT_TRUE(names(instanced, "occludedByInstances("));
    EXPECT_LT(opaque.size(), std::min(translucent.size(), instanced.size()));
}

TEST(Specialise, ConstantsThatAreNotNamedAreAsInTheShader) {
    const std::span<const uint32_t> whole = shaderCode("compensation.comp");
    EXPECT_EQ(specialised(whole, {}), specialised(whole, {{kAlphaTested, 0}, {kInstanced, 0}}));
    EXPECT_EQ(specialised(whole, {{4000, 1}}), specialised(whole, {}));  // nor are those that it has not
}

TEST(Specialise, WhatIsNoModuleIsABug) {
    const std::vector<uint32_t> words = {1, 2, 3, 4, 5};
    EXPECT_THROW(specialised(words, {}), BugError);
}

}  // namespace
}  // namespace manylight::gpu
