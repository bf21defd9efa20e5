#include "engine/scene/gltf_check.h"
#include "shaders/shared/constants.h"

#include <vector>

namespace manylight {
namespace {

/// A node's own weights stand in for those of its mesh.
void checkMorphWeights(const JsonView& root, const JsonView& node, Warnings& warnings) {
    if (!node.has("weights")) return;
    const JsonView weights = node.at("weights").expectArray();
    for (size_t i = 0; i < weights.size(); ++i) weights.at(i).number();
    size_t targetCount = 0;
    if (node.has("mesh")) {
        const JsonView mesh = root.at("meshes").at(static_cast<size_t>(node.at("mesh").integer(0, INT32_MAX)));
        const JsonView primitive = mesh.at("primitives").at(0);
        if (primitive.has("targets")) targetCount = primitive.at("targets").size();
    }
    if (weights.size() != targetCount) warnings.add("glTF morph weights of wrong number", node.path());
}

void checkNode(const JsonView& root, const JsonView& node, std::vector<bool>& hasParent, Warnings& warnings) {
    checkGltfIndex(root, node, "mesh", "meshes");
    checkGltfIndex(root, node, "camera", "cameras");
    checkGltfNumbers(node, "matrix", 16);
    checkGltfNumbers(node, "translation", 3);
    checkGltfNumbers(node, "rotation", 4);
    checkGltfNumbers(node, "scale", 3);
    checkGltfIndex(root, node, "skin", "skins");
    if (node.has("skin") && !node.has("mesh")) warnings.add("skins of nodes without a mesh ignored", node.path());
    checkMorphWeights(root, node, warnings);
    if (!node.has("children")) return;
    const JsonView children = node.at("children").expectArray();
    for (size_t i = 0; i < children.size(); ++i) {
        const int64_t child = children.at(i).integer(0, static_cast<int64_t>(hasParent.size()) - 1);
        if (hasParent[static_cast<size_t>(child)]) children.at(i).failExpected("a node that is no other node's child");
        hasParent[static_cast<size_t>(child)] = true;
    }
}

void checkScenes(const JsonView& root, size_t nodeCount) {
    checkGltfIndex(root, root, "scene", "scenes");
    forEachGltf(root, "scenes", [&](const JsonView& scene) {
        if (!scene.has("nodes")) return;
        const JsonView nodes = scene.at("nodes").expectArray();
        for (size_t i = 0; i < nodes.size(); ++i) nodes.at(i).integer(0, static_cast<int64_t>(nodeCount) - 1);
    });
}

void checkCamera(const JsonView& camera) {
    const std::string type = camera.at("type").text();
    if (type != "perspective" && type != "orthographic") camera.at("type").failExpected("perspective or orthographic");
    if (type == "perspective") camera.at("perspective").at("yfov").positiveNumber();
}

void checkLight(const JsonView& light, Warnings& warnings) {
    const std::string type = light.at("type").text();
    if (type != "point" && type != "spot" && type != "directional")
        light.at("type").failExpected("point, spot or directional");
    if (light.has("color")) light.at("color").nonNegative3();
    if (light.has("intensity") && light.at("intensity").number() < 0.0)
        light.at("intensity").failExpected("a number that is not negative");
    if (light.has("range")) light.at("range").positiveNumber();
    if (light.has("range") && type == "directional") warnings.add("ranges of directional lights ignored", light.path());
    if (type != "spot") return;
    const JsonView spot = light.at("spot").expectObject();
    const double outer = spot.has("outerConeAngle") ? spot.at("outerConeAngle").positiveNumber() : 1.0;
    const double inner = spot.has("innerConeAngle") ? spot.at("innerConeAngle").number() : 0.0;
    if (spot.has("innerConeAngle") && (inner < 0.0 || (spot.has("outerConeAngle") && inner > outer)))
        spot.at("innerConeAngle").failExpected("an angle from zero to outerConeAngle");
    if (outer > double{shared::kPi})
        warnings.add("spot lights shine to all sides: outerConeAngle beyond pi", spot.path());
}

void checkLights(const JsonView& root, Warnings& warnings) {
    constexpr std::string_view kExtension = "KHR_lights_punctual";
    size_t count = 0;
    if (root.has("extensions") && root.at("extensions").has(kExtension)) {
        const JsonView extension = root.at("extensions").at(kExtension);
        const JsonView lights = extension.at("lights").expectArray();
        count = lights.size();
        for (size_t i = 0; i < count; ++i) checkLight(lights.at(i).expectObject(), warnings);
    }
    forEachGltf(root, "nodes", [&](const JsonView& node) {
        if (!node.has("extensions") || !node.at("extensions").has(kExtension)) return;
        node.at("extensions").at(kExtension).at("light").integer(0, static_cast<int64_t>(count) - 1);
    });
}

/// EXT_mesh_gpu_instancing: accessors of equal length.
void checkInstances(const JsonView& root, const JsonView& node) {
    constexpr std::string_view kExtension = "EXT_mesh_gpu_instancing";
    if (!node.has("extensions") || !node.at("extensions").has(kExtension)) return;
    const JsonView attributes = node.at("extensions").at(kExtension).at("attributes").expectObject();
    int64_t count = -1;
    for (const auto& [name, value] : attributes.json().items()) {
        checkGltfIndex(root, attributes, name, "accessors");
        const JsonView accessor = root.at("accessors").at(static_cast<size_t>(value.get<int64_t>()));
        const std::string type = accessor.at("type").text();
        const bool isReadable = name.starts_with('_') || (name == "ROTATION" && type == "VEC4") ||
                                ((name == "TRANSLATION" || name == "SCALE") && type == "VEC3");
        if (!isReadable) attributes.at(name).failExpected("TRANSLATION or SCALE as VEC3, or ROTATION as VEC4");
        const int64_t length = accessor.at("count").integer(1, INT32_MAX);
        if (count >= 0 && length != count) attributes.at(name).failExpected(fmt::format("{} elements", count));
        count = length;
    }
}

}  // namespace

void checkGltfNodes(const JsonView& root, Warnings& warnings) {
    std::vector<bool> hasParent(root.has("nodes") ? root.at("nodes").size() : 0);
    forEachGltf(root, "nodes", [&](const JsonView& node) {
        checkNode(root, node, hasParent, warnings);
        checkInstances(root, node);
    });
    checkScenes(root, hasParent.size());
    forEachGltf(root, "cameras", checkCamera);
    checkLights(root, warnings);
}

}  // namespace manylight
