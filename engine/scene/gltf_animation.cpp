#include "engine/scene/gltf_animation.h"

#include "engine/scene/gltf_check.h"
#include "engine/scene/gltf_morphs.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace manylight {
namespace {

/// The accessor type of a property's values, and how many of them make one.
struct ValueLayout {
    std::string_view type;
    size_t components;
    size_t elements;
};

ValueLayout layoutOf(NodeProperty property, size_t targetCount) {
    if (property == NodeProperty::Weights) return {"SCALAR", 1, targetCount};
    return property == NodeProperty::Rotation ? ValueLayout{"VEC4", 4, 1} : ValueLayout{"VEC3", 3, 1};
}

std::optional<NodeProperty> propertyFrom(const std::string& path) {
    if (path == "translation") return NodeProperty::Translation;
    if (path == "rotation") return NodeProperty::Rotation;
    if (path == "scale") return NodeProperty::Scale;
    if (path == "weights") return NodeProperty::Weights;
    return std::nullopt;
}

KeyInterpolation interpolationOf(const JsonView& sampler) {
    if (!sampler.has("interpolation")) return KeyInterpolation::Linear;
    const std::string name = sampler.at("interpolation").text();
    if (name == "STEP") return KeyInterpolation::Step;
    if (name == "CUBICSPLINE") return KeyInterpolation::CubicSpline;
    if (name != "LINEAR") sampler.at("interpolation").failExpected("LINEAR, STEP or CUBICSPLINE");
    return KeyInterpolation::Linear;
}

class ChannelReader {
  public:
    ChannelReader(const GltfFile& gltf, const JsonView& root, const JsonView& animation)
        : gltf_(gltf), root_(root), samplers_(animation.at("samplers").expectArray()) {}

    NodeChannel read(const JsonView& channel, NodeProperty property, size_t targetCount) const {
        const auto last = static_cast<int64_t>(samplers_.size()) - 1;
        if (last < 0) channel.at("sampler").failExpected("a sampler, and the animation has none");
        const JsonView sampler =
            samplers_.at(static_cast<size_t>(channel.at("sampler").integer(0, last))).expectObject();
        NodeChannel result;
        result.property = property;
        result.interpolation = interpolationOf(sampler);
        result.times = numbersOf(sampler, "input", "SCALAR");
        checkTimes(sampler.at("input"), result.times);
        const ValueLayout layout = layoutOf(property, targetCount);
        result.values = numbersOf(sampler, "output", layout.type);
        const size_t perKey = layout.elements * (result.interpolation == KeyInterpolation::CubicSpline ? 3 : 1);
        const size_t expected = result.times.size() * perKey;
        if (result.values.size() != expected * layout.components)
            sampler.at("output").failExpected(fmt::format("an accessor of {} elements, {} for each of {} key frames",
                                                          expected, perKey, result.times.size()));
        if (!std::ranges::all_of(result.values, [](double value) { return std::isfinite(value); }))
            sampler.at("output").failExpected("an accessor of finite numbers");
        return result;
    }

  private:
    std::vector<double> numbersOf(const JsonView& sampler, std::string_view key, std::string_view type) const {
        const JsonView index = sampler.at(key);
        checkGltfIndex(root_, sampler, key, "accessors");
        const auto accessor = static_cast<size_t>(index.integer(0, INT32_MAX));
        if (root_.at("accessors").at(accessor).at("type").text() != type)
            index.failExpected(fmt::format("an accessor of type {}", type));
        return readGltfNumbers(gltf_, static_cast<int>(accessor));
    }

    static void checkTimes(const JsonView& input, const std::vector<double>& times) {
        if (times.empty()) input.failExpected("at least one key frame");
        for (size_t i = 0; i < times.size(); ++i) {
            if (!std::isfinite(times[i]) || times[i] < 0.0)
                input.failExpected(
                    fmt::format("times that are finite and not negative; key frame {} is at {}", i, times[i]));
            if (i > 0 && times[i] <= times[i - 1])
                input.failExpected(
                    fmt::format("increasing times; key frame {} at {} follows {}", i, times[i], times[i - 1]));
        }
    }

    const GltfFile& gltf_;
    const JsonView& root_;
    JsonView samplers_;
};

size_t targetCountOf(const GltfFile& gltf, const tinygltf::Node& node) {
    return node.mesh < 0 ? 0 : gltfTargetCount(gltf.model.meshes.at(static_cast<size_t>(node.mesh)));
}

glm::dquat quaternionAt(const double* v) { return {v[3], v[0], v[1], v[2]}; }

std::vector<double> unit(const glm::dquat& q) {
    const double length = glm::length(q);
    if (!(length > 0.0)) return {0.0, 0.0, 0.0, 1.0};
    return {q.x / length, q.y / length, q.z / length, q.w / length};
}

/// Between two keys of a cubic spline, `delta` seconds apart; `key` points at the first one's in-tangents.
std::vector<double> splineValue(const double* key, size_t components, double delta, double t) {
    const double t2 = t * t;
    const double t3 = t2 * t;
    std::vector<double> value(components);
    for (size_t c = 0; c < components; ++c) {
        const double start = key[components + c];
        const double outTangent = delta * key[2 * components + c];
        const double inTangent = delta * key[3 * components + c];
        const double end = key[4 * components + c];
        value[c] = (2 * t3 - 3 * t2 + 1) * start + (t3 - 2 * t2 + t) * outTangent + (3 * t2 - 2 * t3) * end +
                   (t3 - t2) * inTangent;
    }
    return value;
}

}  // namespace

NodeAnimation readNodeAnimation(const GltfFile& gltf, Warnings& warnings) {
    NodeAnimation result;
    const JsonView root(gltf.container.json, gltf.container.file);
    const auto nodeCount = static_cast<int64_t>(gltf.model.nodes.size());
    std::set<std::pair<size_t, NodeProperty>> taken;
    size_t numberCount = 0;  // channels may share the numbers of a file
    forEachGltf(root, "animations", [&](const JsonView& animation) {
        const ChannelReader reader(gltf, root, animation.expectObject());
        const JsonView channels = animation.at("channels").expectArray();
        for (size_t i = 0; i < channels.size(); ++i) {
            const JsonView channel = channels.at(i).expectObject();
            const JsonView target = channel.at("target").expectObject();
            const std::optional<NodeProperty> property = propertyFrom(target.at("path").text());
            if (!property || !target.has("node")) {
                warnings.add("animation channels ignored: no property of a node", target.path());
                continue;
            }
            if (target.at("node").integer(INT64_MIN, INT64_MAX) < 0 ||
                target.at("node").integer(0, INT64_MAX) >= nodeCount)
                target.at("node").failExpected(fmt::format("an index into nodes (there are {})", nodeCount));
            const auto nodeIndex = static_cast<size_t>(target.at("node").integer(0, nodeCount - 1));
            const tinygltf::Node& node = gltf.model.nodes[nodeIndex];
            const size_t targetCount = targetCountOf(gltf, node);
            if (property == NodeProperty::Weights && targetCount == 0) {
                warnings.add("animation channels ignored: weights without morph targets", target.path());
                continue;
            }
            NodeChannel read = reader.read(channel, *property, targetCount);
            read.node = nodeIndex;
            numberCount += read.values.size();
            checkGltfAmount(gltf, numberCount, target.path(), "numbers in key frames");
            if (property != NodeProperty::Weights && node.matrix.size() == 16)
                target.at("node").failExpected("a node without a matrix, as its parts are animated");
            result.end = std::max(result.end, read.times.back());
            if (taken.insert({read.node, *property}).second)
                result.channels.push_back(std::move(read));
            else
                warnings.add("animation channels ignored: an earlier one moves the same", target.path());
        }
    });
    return result;
}

std::vector<double> valueAt(const NodeChannel& channel, double time) {
    const bool isSpline = channel.interpolation == KeyInterpolation::CubicSpline;
    const bool isRotation = channel.property == NodeProperty::Rotation;
    const size_t stride = channel.values.size() / channel.times.size();
    const size_t components = isSpline ? stride / 3 : stride;
    const auto keyOf = [&](size_t i) { return channel.values.data() + i * stride; };
    const auto plain = [&](size_t i) {
        const double* const first = keyOf(i) + (isSpline ? components : 0);
        return isRotation ? unit(quaternionAt(first)) : std::vector<double>(first, first + components);
    };
    const auto after = std::ranges::upper_bound(channel.times, time);
    if (after == channel.times.begin()) return plain(0);
    const auto i = static_cast<size_t>(after - channel.times.begin()) - 1;
    if (after == channel.times.end() || channel.interpolation == KeyInterpolation::Step) return plain(i);

    const double delta = channel.times[i + 1] - channel.times[i];
    const double t = (time - channel.times[i]) / delta;
    if (isSpline) {
        std::vector<double> value = splineValue(keyOf(i), components, delta, t);
        return isRotation ? unit(quaternionAt(value.data())) : value;
    }
    std::vector<double> from = plain(i);
    const std::vector<double> to = plain(i + 1);
    if (isRotation) return unit(glm::slerp(quaternionAt(from.data()), quaternionAt(to.data()), t));
    for (size_t c = 0; c < components; ++c) from[c] = (1.0 - t) * from[c] + t * to[c];
    return from;
}

std::vector<NodePose> posesAt(const NodeAnimation& animation, size_t nodeCount, double time) {
    std::vector<NodePose> poses(nodeCount);
    for (const NodeChannel& channel : animation.channels) {
        NodePose& pose = poses[channel.node];
        (channel.property == NodeProperty::Translation ? pose.translation
         : channel.property == NodeProperty::Rotation  ? pose.rotation
         : channel.property == NodeProperty::Scale     ? pose.scale
                                                       : pose.weights) = valueAt(channel, time);
    }
    return poses;
}

}  // namespace manylight
