// glTF animations of nodes: translation, rotation, scale and weights of morph targets by key frames.
#pragma once

#include "engine/scene/gltf_accessor.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace manylight {

enum class NodeProperty : uint8_t { Translation, Rotation, Scale, Weights };
enum class KeyInterpolation : uint8_t { Linear, Step, CubicSpline };

/// One property of one node over time.
struct NodeChannel {
    size_t node = 0;
    NodeProperty property = NodeProperty::Translation;
    KeyInterpolation interpolation = KeyInterpolation::Linear;
    std::vector<double> times;   // seconds, increasing
    std::vector<double> values;  // 3, 4 or any number a key; with cubic splines in-tangents, values and out-tangents
};

/// All animations of the file together. Of several channels for the same property of a node the first counts.
struct NodeAnimation {
    std::vector<NodeChannel> channels;
    double end = 0.0;  // of the last key
};

/// Throws Error naming the file and the JSON path. What is no property of a node (pointers) is counted.
NodeAnimation readNodeAnimation(const GltfFile& gltf, Warnings& warnings);

/// The numbers of a channel: before the first key those of the first, after the last those of the last. Rotations are
/// unit quaternions x, y, z, w, the shorter way round.
std::vector<double> valueAt(const NodeChannel& channel, double time);

/// What an animation gives a node at one time.
struct NodePose {
    std::optional<std::vector<double>> translation;
    std::optional<std::vector<double>> rotation;
    std::optional<std::vector<double>> scale;
    std::optional<std::vector<double>> weights;

    bool moves() const { return translation || rotation || scale; }
};
/// By node.
std::vector<NodePose> posesAt(const NodeAnimation& animation, size_t nodeCount, double time);

}  // namespace manylight
