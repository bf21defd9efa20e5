// glTF animations of nodes: translation, rotation and scale by key frames.
#pragma once

#include "engine/scene/gltf_accessor.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <vector>

namespace manylight {

enum class NodeProperty : uint8_t { Translation, Rotation, Scale };
enum class KeyInterpolation : uint8_t { Linear, Step, CubicSpline };

/// One property of one node over time.
struct NodeChannel {
    size_t node = 0;
    NodeProperty property = NodeProperty::Translation;
    KeyInterpolation interpolation = KeyInterpolation::Linear;
    std::vector<double> times;   // seconds, increasing
    std::vector<double> values;  // 3 or 4 numbers a key; with cubic splines in-tangent, value and out-tangent
};

/// All animations of the file together. Of several channels for the same property of a node the first counts.
struct NodeAnimation {
    std::vector<NodeChannel> channels;
    double end = 0.0;  // of the last key

    bool moves(size_t node) const;
};

/// Throws Error naming the file and the JSON path. What is no transform of a node (morph weights, pointers) is counted.
NodeAnimation readNodeAnimation(const GltfFile& gltf, Warnings& warnings);

/// The value of a channel: before the first key that of the first, after the last that of the last. Rotations are unit
/// quaternions x, y, z, w, the shorter way round.
std::array<double, 4> valueAt(const NodeChannel& channel, double time);

/// What an animation gives a node at one time.
struct NodePose {
    std::optional<std::array<double, 4>> translation;
    std::optional<std::array<double, 4>> rotation;
    std::optional<std::array<double, 4>> scale;
};
/// By node.
std::vector<NodePose> posesAt(const NodeAnimation& animation, size_t nodeCount, double time);

}  // namespace manylight
