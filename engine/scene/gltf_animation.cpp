#include "engine/scene/gltf_animation.h"

#include "engine/scene/gltf_check.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace manylight {
namespace {

size_t componentsOf(NodeProperty property) { return property == NodeProperty::Rotation ? 4 : 3; }

std::optional<NodeProperty> propertyFrom(const std::string& path) {
    if (path == "translation") return NodeProperty::Translation;
    if (path == "rotation") return NodeProperty::Rotation;
    if (path == "scale") return NodeProperty::Scale;
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

    NodeChannel read(const JsonView& channel, NodeProperty property) const {
        const auto last = static_cast<int64_t>(samplers_.size()) - 1;
        if (last < 0) channel.at("sampler").failExpected("a sampler, and the animation has none");
        const JsonView sampler =
            samplers_.at(static_cast<size_t>(channel.at("sampler").integer(0, last))).expectObject();
        NodeChannel result;
        result.property = property;
        result.interpolation = interpolationOf(sampler);
        result.times = numbersOf(sampler, "input", "SCALAR");
        checkTimes(sampler.at("input"), result.times);
        const bool isQuaternion = property == NodeProperty::Rotation;
        result.values = numbersOf(sampler, "output", isQuaternion ? "VEC4" : "VEC3");
        const size_t perKey = result.interpolation == KeyInterpolation::CubicSpline ? 3 : 1;
        const size_t expected = result.times.size() * perKey;
        if (result.values.size() != expected * componentsOf(property))
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

glm::dquat quaternionAt(const double* v) { return {v[3], v[0], v[1], v[2]}; }

std::array<double, 4> unit(const glm::dquat& q) {
    const double length = glm::length(q);
    if (!(length > 0.0)) return {0.0, 0.0, 0.0, 1.0};
    return {q.x / length, q.y / length, q.z / length, q.w / length};
}

/// Between two keys of a cubic spline, `delta` seconds apart; `key` points at the first one's in-tangent.
std::array<double, 4> splineValue(const double* key, size_t components, double delta, double t) {
    const double t2 = t * t;
    const double t3 = t2 * t;
    std::array<double, 4> value{};
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

bool NodeAnimation::moves(size_t node) const {
    return std::ranges::any_of(channels, [node](const NodeChannel& channel) { return channel.node == node; });
}

NodeAnimation readNodeAnimation(const GltfFile& gltf, Warnings& warnings) {
    NodeAnimation result;
    const JsonView root(gltf.container.json, gltf.container.file);
    const auto nodeCount = static_cast<int64_t>(gltf.model.nodes.size());
    std::set<std::pair<size_t, NodeProperty>> taken;
    forEachGltf(root, "animations", [&](const JsonView& animation) {
        const ChannelReader reader(gltf, root, animation.expectObject());
        const JsonView channels = animation.at("channels").expectArray();
        for (size_t i = 0; i < channels.size(); ++i) {
            const JsonView channel = channels.at(i).expectObject();
            const JsonView target = channel.at("target").expectObject();
            const std::optional<NodeProperty> property = propertyFrom(target.at("path").text());
            if (!property || !target.has("node")) {
                warnings.add("animation channels ignored: no transform of a node", target.path());
                continue;
            }
            if (target.at("node").integer(INT64_MIN, INT64_MAX) < 0 ||
                target.at("node").integer(0, INT64_MAX) >= nodeCount)
                target.at("node").failExpected(fmt::format("an index into nodes (there are {})", nodeCount));
            NodeChannel read = reader.read(channel, *property);
            read.node = static_cast<size_t>(target.at("node").integer(0, nodeCount - 1));
            if (gltf.model.nodes[read.node].matrix.size() == 16)
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

std::array<double, 4> valueAt(const NodeChannel& channel, double time) {
    const size_t components = componentsOf(channel.property);
    const bool isSpline = channel.interpolation == KeyInterpolation::CubicSpline;
    const bool isRotation = channel.property == NodeProperty::Rotation;
    const size_t stride = components * (isSpline ? 3 : 1);
    const auto keyOf = [&](size_t i) { return channel.values.data() + i * stride; };
    const auto plain = [&](size_t i) {
        std::array<double, 4> value{};
        std::copy_n(keyOf(i) + (isSpline ? components : 0), components, value.begin());
        return isRotation ? unit(quaternionAt(value.data())) : value;
    };
    const auto after = std::ranges::upper_bound(channel.times, time);
    if (after == channel.times.begin()) return plain(0);
    const auto i = static_cast<size_t>(after - channel.times.begin()) - 1;
    if (after == channel.times.end() || channel.interpolation == KeyInterpolation::Step) return plain(i);

    const double delta = channel.times[i + 1] - channel.times[i];
    const double t = (time - channel.times[i]) / delta;
    if (isSpline) {
        const std::array<double, 4> value = splineValue(keyOf(i), components, delta, t);
        return isRotation ? unit(quaternionAt(value.data())) : value;
    }
    const std::array<double, 4> from = plain(i);
    const std::array<double, 4> to = plain(i + 1);
    if (isRotation) return unit(glm::slerp(quaternionAt(from.data()), quaternionAt(to.data()), t));
    std::array<double, 4> value{};
    for (size_t c = 0; c < components; ++c) value[c] = (1.0 - t) * from[c] + t * to[c];
    return value;
}

std::vector<NodePose> posesAt(const NodeAnimation& animation, size_t nodeCount, double time) {
    std::vector<NodePose> poses(nodeCount);
    for (const NodeChannel& channel : animation.channels) {
        NodePose& pose = poses[channel.node];
        (channel.property == NodeProperty::Translation ? pose.translation
         : channel.property == NodeProperty::Rotation  ? pose.rotation
                                                       : pose.scale) = valueAt(channel, time);
    }
    return poses;
}

}  // namespace manylight
