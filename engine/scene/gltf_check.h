// Checks the JSON of a glTF file before anything uses it: types, ranges and references.
#pragma once

#include "engine/scene/json_view.h"

namespace manylight {

/// Throws Error with file and JSON path for what cannot be read safely. Breaches of the specification that do no harm
/// are counted in `warnings`. After it, every index in the parts that the importer reads points somewhere.
void checkGltf(const JsonView& root, Warnings& warnings);

// The phases of checkGltf().
void checkGltfAccessors(const JsonView& root, Warnings& warnings);
void checkGltfMeshes(const JsonView& root, Warnings& warnings);
void checkGltfMaterials(const JsonView& root, Warnings& warnings);
void checkGltfNodes(const JsonView& root, Warnings& warnings);
void checkGltfSkins(const JsonView& root);

/// Calls `check(element)` for every element of the root's array `key`; each must be an object.
template <typename Check>
void forEachGltf(const JsonView& root, std::string_view key, const Check& check) {
    if (!root.has(key)) return;
    const JsonView array = root.at(key).expectArray();
    for (size_t i = 0; i < array.size(); ++i) check(array.at(i).expectObject());
}

/// If `view` has `key`, it must be an index into the root's array `target`.
void checkGltfIndex(const JsonView& root, const JsonView& view, std::string_view key, std::string_view target);

/// If `view` has `key`, it must be an array of `size` finite numbers.
void checkGltfNumbers(const JsonView& view, std::string_view key, size_t size);

/// Components of an accessor type ("VEC3": 3) and bytes of a component type (5126: 4); zero if there is no such type.
size_t gltfComponentCount(std::string_view type);
size_t gltfComponentSize(int64_t componentType);

}  // namespace manylight
