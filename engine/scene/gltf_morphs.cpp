#include "engine/scene/gltf_morphs.h"

#include <algorithm>

namespace manylight {

size_t gltfTargetCount(const tinygltf::Mesh& mesh) {
    size_t most = 0;
    for (const tinygltf::Primitive& primitive : mesh.primitives) most = std::max(most, primitive.targets.size());
    return most;
}

GltfMorph gltfMorph(const tinygltf::Mesh& mesh, std::span<const double> weights) {
    GltfMorph morph;
    const size_t count = std::min(weights.size(), gltfTargetCount(mesh));
    for (size_t target = 0; target < count; ++target)
        if (weights[target] != 0.0) morph.push_back({target, weights[target]});
    return morph;
}

void addMorphTargets(const GltfFile& gltf, const tinygltf::Primitive& primitive, const std::string& name,
                     const GltfMorph& morph, std::vector<double>& numbers) {
    const size_t vertexCount = gltf.model.accessors.at(static_cast<size_t>(primitive.attributes.at(name))).count;
    const size_t size = numbers.size() / vertexCount;
    bool isChanged = false;
    for (const GltfMorphWeight& part : morph) {
        if (part.target >= primitive.targets.size()) continue;
        const auto found = primitive.targets[part.target].find(name);
        if (found == primitive.targets[part.target].end()) continue;
        const std::vector<double> differences = readGltfNumbers(gltf, found->second);
        const size_t differenceSize = differences.size() / vertexCount;  // a colour may lack its alpha
        for (size_t i = 0; i < vertexCount; ++i)
            for (size_t c = 0; c < std::min(size, differenceSize); ++c)
                numbers[i * size + c] += part.weight * differences[i * differenceSize + c];
        isChanged = true;
    }
    if (!isChanged || !name.starts_with("COLOR_")) return;
    for (double& number : numbers) number = std::clamp(number, 0.0, 1.0);
}

}  // namespace manylight
