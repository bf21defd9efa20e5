#include "engine/scene/gltf_check.h"

namespace manylight {
namespace {

void checkInverseBindMatrices(const JsonView& root, const JsonView& skin, size_t jointCount) {
    constexpr std::string_view kKey = "inverseBindMatrices";
    if (!skin.has(kKey)) return;
    checkGltfIndex(root, skin, kKey, "accessors");
    const JsonView accessor = root.at("accessors").at(static_cast<size_t>(skin.at(kKey).integer(0, INT32_MAX)));
    const bool isMatrix =
        accessor.at("type").text() == "MAT4" && accessor.at("componentType").integer(0, INT32_MAX) == 5126;
    const auto count = static_cast<size_t>(accessor.at("count").integer(1, INT32_MAX));
    if (!isMatrix || count < jointCount)
        skin.at(kKey).failExpected(fmt::format("an accessor of MAT4, float, at least {} elements", jointCount));
}

void checkSkin(const JsonView& root, const JsonView& skin) {
    const JsonView joints = skin.at("joints").expectArray();
    if (joints.size() == 0) joints.failExpected("at least one joint");
    const auto nodeCount = static_cast<int64_t>(root.has("nodes") ? root.at("nodes").size() : 0);
    for (size_t i = 0; i < joints.size(); ++i) {
        const JsonView joint = joints.at(i);
        if (!joint.json().is_number_integer() || joint.integer(INT64_MIN, INT64_MAX) < 0 ||
            joint.integer(INT64_MIN, INT64_MAX) >= nodeCount)
            joint.failExpected(fmt::format("an index into nodes (there are {})", nodeCount));
    }
    checkGltfIndex(root, skin, "skeleton", "nodes");
    checkInverseBindMatrices(root, skin, joints.size());
}

}  // namespace

void checkGltfSkins(const JsonView& root) {
    forEachGltf(root, "skins", [&](const JsonView& skin) { checkSkin(root, skin); });
}

}  // namespace manylight
