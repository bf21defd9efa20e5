#include "engine/scene/gltf_check.h"

namespace manylight {
namespace {

constexpr int64_t kMostElements = INT32_MAX;
// Without data behind it a count is only a claim, and must not be able to fill the memory.
constexpr int64_t kMostElementsWithoutData = 1 << 20;

struct ElementLayout {
    int64_t size = 0;
    int64_t componentSize = 0;
};

/// Columns of matrices start at multiples of four bytes.
int64_t elementSize(std::string_view type, int64_t componentSize) {
    const auto count = static_cast<int64_t>(gltfComponentCount(type));
    if (type == "MAT2" && componentSize == 1) return 8;
    if (type == "MAT3" && componentSize < 4) return componentSize == 1 ? 12 : 24;
    return count * componentSize;
}

/// The bytes [offset, offset + stride * (count - 1) + size) must lie in the buffer view.
void checkFits(const JsonView& root, const JsonView& owner, const ElementLayout& layout, int64_t count, bool isStrided,
               Warnings& warnings) {
    checkGltfIndex(root, owner, "bufferView", "bufferViews");
    const JsonView view = root.at("bufferViews").at(static_cast<size_t>(owner.at("bufferView").integer(0, INT32_MAX)));
    const int64_t viewLength = view.at("byteLength").integer(1, INT64_MAX);
    const int64_t viewOffset = view.has("byteOffset") ? view.at("byteOffset").integer(0, INT64_MAX) : 0;
    const int64_t offset = owner.has("byteOffset") ? owner.at("byteOffset").integer(0, viewLength) : 0;
    int64_t stride = layout.size;
    if (isStrided && view.has("byteStride")) {
        const int64_t given = view.at("byteStride").integer(0, INT32_MAX);
        if (given != 0 && given < layout.size)
            view.at("byteStride").failExpected(fmt::format("at least the {} bytes of an element", layout.size));
        if (given != 0) stride = given;
    }
    if (offset + stride * (count - 1) + layout.size > viewLength)
        fail("{}: {} elements of {} bytes from byte {} do not fit the {} bytes of {}", owner.place(), count,
             layout.size, offset, viewLength, view.path());
    if (offset % layout.componentSize != 0 || (viewOffset + offset) % layout.componentSize != 0 ||
        stride % layout.componentSize != 0)
        warnings.add("glTF accessors that are misaligned", owner.path());
}

void checkSparse(const JsonView& root, const JsonView& accessor, const ElementLayout& layout, int64_t count,
                 Warnings& warnings) {
    const JsonView sparse = accessor.at("sparse").expectObject();
    const int64_t changed = sparse.at("count").integer(1, count);
    const JsonView indices = sparse.at("indices").expectObject();
    const int64_t indexType = indices.at("componentType").integer(0, INT32_MAX);
    if (indexType != 5121 && indexType != 5123 && indexType != 5125)
        indices.at("componentType").failExpected("5121, 5123 or 5125");
    const auto indexSize = static_cast<int64_t>(gltfComponentSize(indexType));
    checkFits(root, indices, {indexSize, indexSize}, changed, false, warnings);
    checkFits(root, sparse.at("values").expectObject(), layout, changed, false, warnings);
}

void checkAccessor(const JsonView& root, const JsonView& accessor, Warnings& warnings) {
    const int64_t componentType = accessor.at("componentType").integer(0, INT32_MAX);
    const auto componentSize = static_cast<int64_t>(gltfComponentSize(componentType));
    if (componentSize == 0) accessor.at("componentType").failExpected("5120, 5121, 5122, 5123, 5125 or 5126");
    const bool hasData = accessor.has("bufferView");
    const int64_t count = accessor.at("count").integer(1, hasData ? kMostElements : kMostElementsWithoutData);
    if (accessor.has("normalized") && accessor.at("normalized").boolean() && componentSize == 4)
        warnings.add("glTF accessors that normalise numbers of 32 bits", accessor.path());
    if (!hasData && accessor.has("byteOffset"))
        warnings.add("glTF accessors with byteOffset but no bufferView", accessor.path());
    const std::string type = accessor.at("type").text();
    if (gltfComponentCount(type) == 0) {
        warnings.add("glTF accessors of unknown type", fmt::format("{} {}", accessor.path(), type));
        return;
    }
    const ElementLayout layout{elementSize(type, componentSize), componentSize};
    if (hasData) checkFits(root, accessor, layout, count, true, warnings);
    if (accessor.has("sparse")) checkSparse(root, accessor, layout, count, warnings);
}

}  // namespace

void checkGltfAccessors(const JsonView& root, Warnings& warnings) {
    forEachGltf(root, "accessors", [&](const JsonView& accessor) { checkAccessor(root, accessor, warnings); });
}

}  // namespace manylight
