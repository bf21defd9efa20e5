#include "engine/scene/gltf_node_transforms.h"

#include <glm/gtc/quaternion.hpp>

#include <array>
#include <span>

namespace manylight {
namespace {

using Numbers = std::span<const double>;

/// Scales, then rotates by the quaternion (x, y, z, w), then moves. Empty parts change nothing.
glm::dmat4 composed(Numbers translation, Numbers rotation, Numbers scale) {
    glm::dmat4 matrix(1.0);
    if (!rotation.empty()) {
        const glm::dquat quaternion(rotation[3], rotation[0], rotation[1], rotation[2]);
        const double length = glm::length(quaternion);
        if (length > 0.0) matrix = glm::mat4_cast(quaternion / length);
    }
    if (!scale.empty())
        for (int axis = 0; axis < 3; ++axis) matrix[axis] *= scale[static_cast<size_t>(axis)];
    if (!translation.empty()) matrix[3] = {translation[0], translation[1], translation[2], 1.0};
    return matrix;
}

/// The attributes of EXT_mesh_gpu_instancing, or nullptr.
const tinygltf::Value* instanceAttributes(const tinygltf::Node& node) {
    const auto found = node.extensions.find("EXT_mesh_gpu_instancing");
    return found == node.extensions.end() ? nullptr : &found->second.Get("attributes");
}

constexpr const char* kInstanceAttributes[] = {"TRANSLATION", "ROTATION", "SCALE"};

size_t instanceCount(const GltfFile& gltf, const tinygltf::Node& node) {
    const tinygltf::Value* const attributes = instanceAttributes(node);
    if (!attributes) return 1;
    for (const char* name : kInstanceAttributes)
        if (attributes->Has(name))
            return gltf.model.accessors.at(static_cast<size_t>(attributes->Get(name).GetNumberAsInt())).count;
    return 0;
}

}  // namespace

glm::dmat4 parentFromNode(const tinygltf::Node& node, const NodePose& pose) {
    const auto part = [](const std::optional<std::vector<double>>& posed, const std::vector<double>& own) {
        return Numbers(posed ? *posed : own);
    };
    if (node.matrix.size() != 16)
        return composed(part(pose.translation, node.translation), part(pose.rotation, node.rotation),
                        part(pose.scale, node.scale));
    glm::dmat4 matrix(1.0);
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node.matrix[static_cast<size_t>(i)];
    return matrix;
}

bool hasGltfInstances(const tinygltf::Node& node) { return instanceAttributes(node) != nullptr; }

std::vector<glm::dmat4> instancesOf(const GltfFile& gltf, const tinygltf::Node& node) {
    const tinygltf::Value* const attributes = instanceAttributes(node);
    if (!attributes) return {glm::dmat4(1.0)};
    std::array<std::vector<double>, 3> numbers;
    for (size_t i = 0; i < numbers.size(); ++i)
        if (attributes->Has(kInstanceAttributes[i]))
            numbers[i] = readGltfNumbers(gltf, attributes->Get(kInstanceAttributes[i]).GetNumberAsInt());
    const auto part = [&](size_t attribute, size_t i, size_t size) {
        return numbers[attribute].empty() ? Numbers() : Numbers(numbers[attribute]).subspan(i * size, size);
    };
    std::vector<glm::dmat4> instances(instanceCount(gltf, node));
    for (size_t i = 0; i < instances.size(); ++i) instances[i] = composed(part(0, i, 3), part(1, i, 4), part(2, i, 3));
    return instances;
}

}  // namespace manylight
