#include "engine/scene/gltf_check.h"

#include <fmt/ranges.h>

#include <algorithm>

namespace manylight {
namespace {

constexpr std::string_view kKnownExtensions[] = {
    "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_ior",     "KHR_materials_specular",
    "KHR_materials_unlit", "KHR_texture_transform",           "KHR_mesh_quantization", "EXT_mesh_gpu_instancing"};
constexpr std::string_view kArrays[] = {"accessors", "animations", "buffers",  "bufferViews",    "cameras",
                                        "images",    "materials",  "meshes",   "nodes",          "samplers",
                                        "scenes",    "skins",      "textures", "extensionsUsed", "extensionsRequired"};

bool isKnownExtension(std::string_view name) {
    return std::find(std::begin(kKnownExtensions), std::end(kKnownExtensions), name) != std::end(kKnownExtensions);
}

void checkAsset(const JsonView& root) {
    const JsonView version = root.at("asset").at("version");
    if (!version.text().starts_with("2.")) version.failExpected("version 2.x");
    if (!root.at("asset").has("minVersion")) return;
    const JsonView least = root.at("asset").at("minVersion");
    if (least.text() != "2.0") least.failExpected("minVersion 2.0");
}

void checkExtensions(const JsonView& root, Warnings& warnings) {
    const auto forEachName = [&](std::string_view key, const auto& visit) {
        if (!root.has(key)) return;
        for (size_t i = 0; i < root.at(key).size(); ++i) visit(root.at(key).at(i));
    };
    forEachName("extensionsRequired", [](const JsonView& name) {
        if (!isKnownExtension(name.text()))
            name.failExpected(fmt::format("one of {}", fmt::join(kKnownExtensions, ", ")));
    });
    forEachName("extensionsUsed", [&](const JsonView& name) {
        if (!isKnownExtension(name.text())) warnings.add("glTF extensions ignored", name.text());
    });
}

void checkArrays(const JsonView& root, Warnings& warnings) {
    for (const std::string_view key : kArrays) {
        if (!root.has(key)) continue;
        if (root.at(key).expectArray().size() == 0) warnings.add("glTF arrays that are empty", key);
    }
}

void checkBuffers(const JsonView& root, Warnings& warnings) {
    forEachGltf(root, "buffers", [&](const JsonView& buffer) {
        buffer.at("byteLength").integer(1, int64_t{1} << 40);
        if (buffer.has("uri")) buffer.at("uri").text();
    });
    forEachGltf(root, "bufferViews", [&](const JsonView& view) {
        checkGltfIndex(root, view, "buffer", "buffers");
        const JsonView buffer = root.at("buffers").at(static_cast<size_t>(view.at("buffer").integer(0, INT32_MAX)));
        const int64_t bufferLength = buffer.at("byteLength").integer(1, int64_t{1} << 40);
        const int64_t offset = view.has("byteOffset") ? view.at("byteOffset").integer(0, bufferLength) : 0;
        view.at("byteLength").integer(1, bufferLength - offset);
        if (!view.has("byteStride")) return;
        const int64_t stride = view.at("byteStride").integer(0, INT32_MAX);
        if (stride < 4 || stride > 252 || stride % 4 != 0)
            warnings.add("glTF strides that are no multiple of 4 in [4, 252]", view.path());
    });
}

}  // namespace

void checkGltfIndex(const JsonView& root, const JsonView& view, std::string_view key, std::string_view target) {
    if (!view.has(key)) return;
    const auto count = static_cast<int64_t>(root.has(target) ? root.at(target).expectArray().size() : 0);
    const JsonView index = view.at(key);
    const Json& json = index.json();
    const bool isInside = json.is_number_integer() && index.integer(INT64_MIN, INT64_MAX) >= 0 &&
                          index.integer(INT64_MIN, INT64_MAX) < count;
    if (!isInside) index.failExpected(fmt::format("an index into {} (there are {})", target, count));
}

void checkGltfNumbers(const JsonView& view, std::string_view key, size_t size) {
    if (!view.has(key)) return;
    const JsonView numbers = view.at(key);
    if (numbers.expectArray().size() != size) numbers.failExpected(fmt::format("{} numbers", size));
    for (size_t i = 0; i < size; ++i) numbers.at(i).number();
}

size_t gltfComponentCount(std::string_view type) {
    static constexpr std::pair<std::string_view, size_t> kTypes[] = {
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
    for (const auto& [name, count] : kTypes)
        if (name == type) return count;
    return 0;
}

size_t gltfComponentSize(int64_t componentType) {
    switch (componentType) {
        case 5120:
        case 5121:
            return 1;
        case 5122:
        case 5123:
            return 2;
        case 5125:
        case 5126:
            return 4;
        default:
            return 0;
    }
}

void checkGltf(const JsonView& root, Warnings& warnings) {
    root.expectObject();
    checkAsset(root);
    checkArrays(root, warnings);
    checkExtensions(root, warnings);
    checkBuffers(root, warnings);
    checkGltfAccessors(root, warnings);
    checkGltfMaterials(root, warnings);
    checkGltfMeshes(root, warnings);
    checkGltfNodes(root, warnings);
    checkGltfSkins(root);
}

}  // namespace manylight
