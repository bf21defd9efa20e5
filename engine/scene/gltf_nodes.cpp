#include "engine/scene/gltf_nodes.h"

#include "engine/core/error.h"
#include "engine/scene/gltf_animation.h"
#include "engine/scene/gltf_instances.h"
#include "shaders/shared/constants.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
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

glm::dmat4 parentFromNode(const tinygltf::Node& node, const NodePose& pose) {
    const auto part = [](const std::optional<std::array<double, 4>>& posed, const std::vector<double>& own,
                         size_t size) { return posed ? Numbers(*posed).first(size) : Numbers(own); };
    if (node.matrix.size() != 16)
        return composed(part(pose.translation, node.translation, 3), part(pose.rotation, node.rotation, 4),
                        part(pose.scale, node.scale, 3));
    glm::dmat4 matrix(1.0);
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node.matrix[static_cast<size_t>(i)];
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

/// Transforms of the node's instances, or the identity alone.
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

void addCamera(const GltfFile& gltf, int index, const glm::dmat4& sceneFromNode, RawScene& scene) {
    const tinygltf::Camera& source = gltf.model.cameras.at(static_cast<size_t>(index));
    if (source.type != "perspective") {
        scene.warnings.add("orthographic cameras dropped", fmt::format("cameras[{}]", index));
        return;
    }
    scene.cameras.push_back({.name = source.name.empty() ? fmt::format("camera {}", index) : source.name,
                             .origin = glm::dvec3(sceneFromNode[3]),
                             .forward = -glm::dvec3(sceneFromNode[2]),
                             .up = glm::dvec3(sceneFromNode[1]),
                             .verticalFov = source.perspective.yfov,
                             .resolution = std::nullopt});
}

void addLight(const GltfFile& gltf, int index, const glm::dmat4& sceneFromNode, RawScene& scene) {
    const tinygltf::Light& source = gltf.model.lights.at(static_cast<size_t>(index));
    RawLight light;
    light.name = source.name.empty() ? fmt::format("light {}", index) : source.name;
    light.type = source.type == "spot"          ? LightType::Spot
                 : source.type == "directional" ? LightType::Directional
                                                : LightType::Point;
    light.position = glm::dvec3(sceneFromNode[3]);
    light.direction = -glm::dvec3(sceneFromNode[2]);
    const glm::dvec3 colour =
        source.color.size() == 3 ? glm::dvec3(source.color[0], source.color[1], source.color[2]) : glm::dvec3(1.0);
    light.emission = source.intensity * colour;
    const double cutoff = std::min(source.spot.outerConeAngle, double{shared::kPi});
    light.cosBeam = std::cos(std::min(source.spot.innerConeAngle, cutoff));
    light.cosCutoff = std::cos(cutoff);
    if (source.range > 0.0) light.range = source.range;
    scene.lights.push_back(std::move(light));
}

class NodeWalker {
  public:
    NodeWalker(const GltfFile& gltf, const ImportOptions& options, RawScene& scene)
        : gltf_(gltf), scene_(scene), isVisited_(gltf.model.nodes.size()), poses_(isVisited_.size()) {
        if (!options.time) return;
        const NodeAnimation animation = readNodeAnimation(gltf, scene.warnings);
        poses_ = posesAt(animation, poses_.size(), *options.time);
        scene.animationEnd = animation.end;
    }

    /// Adds cameras and lights; returns the meshes that are shown.
    std::vector<GltfMeshUse> walk() {
        // A stack of our own: the depth of the hierarchy is the file's choice.
        for (const int root : roots()) {
            stack_.push_back({root, glm::dmat4(1.0), false});
            while (!stack_.empty()) {
                const Pending next = stack_.back();
                stack_.pop_back();
                visit(next);
            }
        }
        const auto unreached = std::count(isVisited_.begin(), isVisited_.end(), false);
        scene_.warnings.add("glTF nodes outside the default scene", {}, static_cast<uint64_t>(unreached));
        return std::move(uses_);
    }

  private:
    struct Pending {
        int node;
        glm::dmat4 sceneFromParent;
        bool parentMoves;
    };

    std::vector<int> roots() {
        const tinygltf::Model& model = gltf_.model;
        if (!model.scenes.empty()) {
            if (model.defaultScene < 0) scene_.warnings.add("glTF files without a default scene: the first is shown");
            return model.scenes[static_cast<size_t>(std::max(model.defaultScene, 0))].nodes;
        }
        if (!model.nodes.empty()) scene_.warnings.add("glTF files without a scene: all nodes are shown");
        std::vector<bool> isChild(model.nodes.size());
        for (const tinygltf::Node& node : model.nodes)
            for (const int child : node.children) isChild[static_cast<size_t>(child)] = true;
        std::vector<int> found;
        for (size_t i = 0; i < isChild.size(); ++i)
            if (!isChild[i]) found.push_back(static_cast<int>(i));
        return found;
    }

    void visit(const Pending& pending) {
        const int index = pending.node;
        const auto number = static_cast<size_t>(index);
        if (isVisited_[number]) fail("{}: nodes[{}]: reached twice, expected a tree", gltf_.container.file, index);
        isVisited_[number] = true;
        const tinygltf::Node& node = gltf_.model.nodes[number];
        const NodePose& pose = poses_[number];
        const bool moves = pending.parentMoves || pose.translation || pose.rotation || pose.scale;
        const glm::dmat4 sceneFromNode = pending.sceneFromParent * parentFromNode(node, pose);
        if (node.mesh >= 0) addInstances(node, fmt::format("nodes[{}]", index), sceneFromNode, moves);
        if (node.camera >= 0) addCamera(gltf_, node.camera, sceneFromNode, scene_);
        if (const auto found = node.extensions.find("KHR_lights_punctual"); found != node.extensions.end())
            addLight(gltf_, found->second.Get("light").GetNumberAsInt(), sceneFromNode, scene_);
        for (size_t i = node.children.size(); i-- > 0;) stack_.push_back({node.children[i], sceneFromNode, moves});
    }

    void addInstances(const tinygltf::Node& node, const std::string& place, const glm::dmat4& sceneFromNode,
                      bool moves) {
        const std::vector<glm::dmat4> instances = instancesOf(gltf_, node);
        drawnPrimitives_ += instances.size() * gltf_.model.meshes.at(static_cast<size_t>(node.mesh)).primitives.size();
        checkGltfAmount(gltf_, drawnPrimitives_, place, "drawn primitives");
        for (const glm::dmat4& nodeFromInstance : instances)
            uses_.push_back({node.mesh, sceneFromNode * nodeFromInstance, place, moves});
    }

    const GltfFile& gltf_;
    RawScene& scene_;
    std::vector<GltfMeshUse> uses_;
    size_t drawnPrimitives_ = 0;
    std::vector<bool> isVisited_;
    std::vector<NodePose> poses_;  // by node
    std::vector<Pending> stack_;
};

}  // namespace

void addGltfNodes(const GltfFile& gltf, const ImportOptions& options, RawScene& scene) {
    addGltfMeshUses(gltf, NodeWalker(gltf, options, scene).walk(), options, scene);
    std::vector<bool> isUsed(gltf.model.meshes.size());
    for (const tinygltf::Node& node : gltf.model.nodes)
        if (node.mesh >= 0) isUsed[static_cast<size_t>(node.mesh)] = true;
    const auto unused = std::count(isUsed.begin(), isUsed.end(), false);
    scene.warnings.add("glTF meshes that no node uses", {}, static_cast<uint64_t>(unused));
}

}  // namespace manylight
