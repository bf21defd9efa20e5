#include "engine/scene/gltf_nodes.h"

#include "engine/core/error.h"
#include "engine/scene/gltf_instances.h"
#include "engine/scene/gltf_node_transforms.h"
#include "engine/scene/gltf_skins.h"
#include "shaders/shared/constants.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace manylight {
namespace {

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
        : gltf_(gltf), scene_(scene), places_(gltf.model.nodes.size()), poses_(places_.size()) {
        if (!options.time) return;
        const NodeAnimation animation = readNodeAnimation(gltf, scene.warnings);
        poses_ = posesAt(animation, poses_.size(), *options.time);
        scene.animationEnd = animation.end;
    }

    /// Adds cameras and lights; returns the meshes that are shown.
    std::vector<GltfMeshUse> walk() {
        // A stack of our own: the depth of the hierarchy is the file's choice.
        for (const int root : roots()) visitFrom(root, true);
        const auto unreached = std::ranges::count_if(places_, [](const NodePlace& place) { return !place.isKnown; });
        scene_.warnings.add("glTF nodes outside the default scene", {}, static_cast<uint64_t>(unreached));
        takeSkins();
        return std::move(uses_);
    }

  private:
    struct Pending {
        int node;
        glm::dmat4 sceneFromParent;
        bool parentMoves;
    };

    struct Skin {
        std::shared_ptr<const std::vector<glm::dmat4>> joints;
        bool moves = false;
    };

    std::vector<int> roots() {
        const tinygltf::Model& model = gltf_.model;
        if (!model.scenes.empty()) {
            if (model.defaultScene < 0) scene_.warnings.add("glTF files without a default scene: the first is shown");
            return model.scenes[static_cast<size_t>(std::max(model.defaultScene, 0))].nodes;
        }
        if (!model.nodes.empty()) scene_.warnings.add("glTF files without a scene: all nodes are shown");
        return parentless();
    }

    std::vector<int> parentless() const {
        const tinygltf::Model& model = gltf_.model;
        std::vector<bool> isChild(model.nodes.size());
        for (const tinygltf::Node& node : model.nodes)
            for (const int child : node.children) isChild[static_cast<size_t>(child)] = true;
        std::vector<int> found;
        for (size_t i = 0; i < isChild.size(); ++i)
            if (!isChild[i]) found.push_back(static_cast<int>(i));
        return found;
    }

    /// Shown is what hangs on the nodes of the scene. Others have a place, for skins to know.
    void visitFrom(int root, bool isShown) {
        stack_.push_back({root, glm::dmat4(1.0), false});
        while (!stack_.empty()) {
            const Pending next = stack_.back();
            stack_.pop_back();
            visit(next, isShown);
        }
    }

    void visit(const Pending& pending, bool isShown) {
        const int index = pending.node;
        const auto number = static_cast<size_t>(index);
        if (places_[number].isKnown) {
            if (!isShown) return;
            fail("{}: nodes[{}]: reached twice, expected a tree", gltf_.container.file, index);
        }
        const tinygltf::Node& node = gltf_.model.nodes[number];
        const NodePose& pose = poses_[number];
        const bool moves = pending.parentMoves || pose.moves();
        const glm::dmat4 sceneFromNode = pending.sceneFromParent * parentFromNode(node, pose);
        places_[number] = {sceneFromNode, true, moves};
        if (isShown) show(index, node, sceneFromNode);
        for (size_t i = node.children.size(); i-- > 0;) stack_.push_back({node.children[i], sceneFromNode, moves});
    }

    void show(int index, const tinygltf::Node& node, const glm::dmat4& sceneFromNode) {
        if (node.mesh >= 0) addInstances(index, node, sceneFromNode);
        if (node.camera >= 0) addCamera(gltf_, node.camera, sceneFromNode, scene_);
        if (const auto found = node.extensions.find("KHR_lights_punctual"); found != node.extensions.end())
            addLight(gltf_, found->second.Get("light").GetNumberAsInt(), sceneFromNode, scene_);
    }

    void addInstances(int index, const tinygltf::Node& node, const glm::dmat4& sceneFromNode) {
        const std::string place = fmt::format("nodes[{}]", index);
        const auto number = static_cast<size_t>(index);
        std::vector<glm::dmat4> instances = instancesOf(gltf_, node);
        if (node.skin >= 0 && hasGltfInstances(node)) {
            scene_.warnings.add("instances of meshes with skins ignored", place);
            instances = {glm::dmat4(1.0)};
        }
        const tinygltf::Mesh& mesh = gltf_.model.meshes.at(static_cast<size_t>(node.mesh));
        drawnPrimitives_ += instances.size() * mesh.primitives.size();
        checkGltfAmount(gltf_, drawnPrimitives_, place, "drawn primitives");
        GltfMeshUse use{.mesh = node.mesh, .place = place, .moves = places_[number].moves};
        use.shape.morph = morphOf(node, poses_[number]);
        use.deforms = poses_[number].weights.has_value();
        if (use.deforms) noteShape(*poses_[number].weights);
        countMorphed(mesh, use, instances.size());
        for (const glm::dmat4& nodeFromInstance : instances) {
            use.sceneFromMesh = sceneFromNode * nodeFromInstance;
            if (node.skin >= 0) skinned_.push_back({uses_.size(), static_cast<size_t>(node.skin)});
            uses_.push_back(use);
        }
    }

    /// The weights of the animation, else the node's own, else the mesh's.
    std::shared_ptr<const GltfMorph> morphOf(const tinygltf::Node& node, const NodePose& pose) {
        const tinygltf::Mesh& mesh = gltf_.model.meshes.at(static_cast<size_t>(node.mesh));
        if (pose.weights || !node.weights.empty())
            return std::make_shared<const GltfMorph>(gltfMorph(mesh, pose.weights ? *pose.weights : node.weights));
        std::shared_ptr<const GltfMorph>& ofMesh = morphsOfMeshes_[node.mesh];
        if (!ofMesh) ofMesh = std::make_shared<const GltfMorph>(gltfMorph(mesh, mesh.weights));
        return ofMesh;
    }

    void countMorphed(const tinygltf::Mesh& mesh, const GltfMeshUse& use, size_t instances) {
        for (const tinygltf::Primitive& primitive : mesh.primitives)
            if (const auto found = primitive.attributes.find("POSITION"); found != primitive.attributes.end())
                morphedVertices_ += instances * std::min(use.shape.morph->size(), primitive.targets.size()) *
                                    gltf_.model.accessors.at(static_cast<size_t>(found->second)).count;
        checkGltfAmount(gltf_, morphedVertices_, use.place, "vertices of morph targets");
    }

    void noteShape(std::span<const double> numbers) {
        scene_.shape.insert(scene_.shape.end(), numbers.begin(), numbers.end());
    }

    /// Once all nodes have their places: joints may come after the meshes that follow them.
    void takeSkins() {
        if (skinned_.empty()) return;
        for (const int root : parentless()) visitFrom(root, false);
        GltfSkins skins(gltf_, places_, scene_.warnings);
        std::map<size_t, Skin> taken;
        for (const auto& [index, number] : skinned_) {
            GltfMeshUse& use = uses_[index];
            Skin& skin = taken[number];
            if (!skin.joints) {
                skin = {std::make_shared<const std::vector<glm::dmat4>>(skins.sceneFromBound(number)),
                        skins.moves(number)};
                if (skin.moves)
                    for (const glm::dmat4& joint : *skin.joints) noteShape({&joint[0][0], 16});
            }
            if (use.moves) noteShape({&use.sceneFromMesh[0][0], 16});  // where parts of it follow no joint
            use.shape.sceneFromBound = skin.joints;
            use.deforms = use.deforms || use.moves || skin.moves;
        }
    }

    const GltfFile& gltf_;
    RawScene& scene_;
    std::vector<GltfMeshUse> uses_;
    size_t drawnPrimitives_ = 0;
    size_t morphedVertices_ = 0;
    std::map<int, std::shared_ptr<const GltfMorph>> morphsOfMeshes_;  // at the weights of the mesh
    std::vector<std::pair<size_t, size_t>> skinned_;                  // indices into uses_, and their skins
    std::vector<NodePlace> places_;                                   // by node
    std::vector<NodePose> poses_;
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
