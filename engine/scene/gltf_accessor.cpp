#include "engine/scene/gltf_accessor.h"

#include "engine/core/check.h"
#include "engine/core/error.h"

#include <algorithm>
#include <cstring>

namespace manylight {
namespace {

template <typename T>
T load(const uint8_t* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);  // files may be misaligned
    return value;
}

double loadNumber(const uint8_t* bytes, int componentType, bool isNormalised) {
    const auto scaled = [&](double value, double most) { return isNormalised ? std::max(value / most, -1.0) : value; };
    switch (componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return scaled(load<int8_t>(bytes), 127.0);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return scaled(load<uint8_t>(bytes), 255.0);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return scaled(load<int16_t>(bytes), 32767.0);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return scaled(load<uint16_t>(bytes), 65535.0);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return load<uint32_t>(bytes);
        default:
            return double{load<float>(bytes)};
    }
}

/// A run of elements in a buffer, checked against the view's end.
struct ElementRun {
    const uint8_t* bytes = nullptr;
    size_t stride = 0;

    ElementRun(const GltfFile& gltf, int view, size_t offset, size_t elementSize, size_t count, size_t viewStride) {
        const auto [begin, size] = gltfViewBytes(gltf, view);
        stride = viewStride != 0 ? viewStride : elementSize;
        MANYLIGHT_CHECK(offset + stride * (count - 1) + elementSize <= size, "{} bufferViews[{}]", gltf.container.file,
                        view);
        bytes = begin + offset;
    }
    const uint8_t* at(size_t element) const { return bytes + element * stride; }
};

void applySparse(const GltfFile& gltf, const tinygltf::Accessor& accessor, size_t componentCount, size_t componentSize,
                 std::vector<double>& numbers) {
    const auto changed = static_cast<size_t>(accessor.sparse.count);
    const int indexType = accessor.sparse.indices.componentType;
    const auto indexSize = static_cast<size_t>(tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(indexType)));
    const ElementRun indices(gltf, accessor.sparse.indices.bufferView,
                             static_cast<size_t>(accessor.sparse.indices.byteOffset), indexSize, changed, 0);
    const size_t elementSize = componentCount * componentSize;
    const ElementRun values(gltf, accessor.sparse.values.bufferView,
                            static_cast<size_t>(accessor.sparse.values.byteOffset), elementSize, changed, 0);
    for (size_t i = 0; i < changed; ++i) {
        const auto element = static_cast<size_t>(loadNumber(indices.at(i), indexType, false));
        if (element >= accessor.count)
            fail("{}: sparse index {} of accessor \"{}\" is out of range, expected less than {}", gltf.container.file,
                 element, accessor.name, accessor.count);
        for (size_t c = 0; c < componentCount; ++c)
            numbers[element * componentCount + c] =
                loadNumber(values.at(i) + c * componentSize, accessor.componentType, accessor.normalized);
    }
}

}  // namespace

void checkGltfAmount(const GltfFile& gltf, size_t count, std::string_view place, std::string_view what) {
    if (count > gltf.mostElements)
        fail("{}: {}: more than {} {}, which is too many for a file of {} bytes", gltf.container.file, place,
             gltf.mostElements, what, gltf.container.byteCount);
}

std::pair<const uint8_t*, size_t> gltfViewBytes(const GltfFile& gltf, int bufferView) {
    const tinygltf::BufferView& view = gltf.model.bufferViews.at(static_cast<size_t>(bufferView));
    const GltfBuffer& buffer = gltf.container.buffers.at(static_cast<size_t>(view.buffer));
    if (!buffer.fault.empty()) throw Error(buffer.fault);
    MANYLIGHT_CHECK(view.byteOffset + view.byteLength <= buffer.bytes.size(), "{} bufferViews[{}]", gltf.container.file,
                    bufferView);
    return {buffer.bytes.data() + view.byteOffset, view.byteLength};
}

std::vector<double> readGltfNumbers(const GltfFile& gltf, int accessorIndex) {
    const tinygltf::Accessor& accessor = gltf.model.accessors.at(static_cast<size_t>(accessorIndex));
    const auto componentCount =
        static_cast<size_t>(tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type)));
    const auto componentSize =
        static_cast<size_t>(tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(accessor.componentType)));
    std::vector<double> numbers(accessor.count * componentCount, 0.0);
    if (static_cast<size_t>(accessor.bufferView) < gltf.viewCount) {
        const size_t stride = gltf.model.bufferViews.at(static_cast<size_t>(accessor.bufferView)).byteStride;
        const ElementRun run(gltf, accessor.bufferView, accessor.byteOffset, componentCount * componentSize,
                             accessor.count, stride);
        for (size_t i = 0; i < accessor.count; ++i)
            for (size_t c = 0; c < componentCount; ++c)
                numbers[i * componentCount + c] =
                    loadNumber(run.at(i) + c * componentSize, accessor.componentType, accessor.normalized);
    }
    if (accessor.sparse.isSparse) applySparse(gltf, accessor, componentCount, componentSize, numbers);
    return numbers;
}

std::vector<uint32_t> readGltfIndices(const GltfFile& gltf, int accessor) {
    const std::vector<double> numbers = readGltfNumbers(gltf, accessor);  // doubles hold any 32-bit index exactly
    return {numbers.begin(), numbers.end()};
}

}  // namespace manylight
