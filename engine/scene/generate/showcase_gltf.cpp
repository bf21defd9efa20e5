// The showcase's meshes, nodes and lights as glTF, and what is seen through the window.
#include "engine/scene/generate/generated_scene.h"
#include "engine/scene/generate/showcase_parts.h"
#include "shaders/shared/constants.h"

#include <algorithm>
#include <cmath>

namespace manylight::showcase {
namespace {

constexpr const char* kLights = "KHR_lights_punctual";

template <typename T>
size_t addCorners(GltfText& gltf, const Surface& surface, T Corner::* member, const char* type) {
    std::vector<T> values;
    for (const Corner& corner : surface.corners) values.push_back(corner.*member);
    return addGltfAccessor(gltf, values.data(), values.size() * sizeof(T), values.size(), GltfNumber::Float, type);
}

size_t addPositions(GltfText& gltf, const Surface& surface) {
    const size_t accessor = addCorners(gltf, surface, &Corner::position, "VEC3");
    glm::vec3 low = surface.corners.front().position;
    glm::vec3 high = low;
    for (const Corner& corner : surface.corners) {
        low = glm::min(low, corner.position);
        high = glm::max(high, corner.position);
    }
    gltf.json["accessors"][accessor]["min"] = toJson(low);
    gltf.json["accessors"][accessor]["max"] = toJson(high);
    return accessor;
}

Json primitiveOf(GltfText& gltf, const Surface& surface) {
    Json attributes{{"POSITION", addPositions(gltf, surface)},
                    {"NORMAL", addCorners(gltf, surface, &Corner::normal, "VEC3")},
                    {"TEXCOORD_0", addCorners(gltf, surface, &Corner::uv, "VEC2")},
                    {"TEXCOORD_1", addCorners(gltf, surface, &Corner::uv1, "VEC2")}};
    const bool isColoured =
        std::ranges::any_of(surface.corners, [](const Corner& corner) { return corner.colour != glm::vec4(1.0f); });
    if (isColoured) attributes["COLOR_0"] = addCorners(gltf, surface, &Corner::colour, "VEC4");
    const std::vector<uint32_t>& indices = surface.indices;
    return {{"attributes", attributes},
            {"indices", addGltfAccessor(gltf, indices.data(), indices.size() * sizeof(uint32_t), indices.size(),
                                        GltfNumber::UnsignedInt, "SCALAR")},
            {"material", surface.material}};
}

Json nodeAt(const Pose& pose) {
    const glm::dquat& q = pose.turn;
    return {{"translation", toJson(pose.origin)}, {"rotation", {q.x, q.y, q.z, q.w}}, {"scale", toJson(pose.scale)}};
}

void addNode(GltfText& gltf, Json node) {
    gltf.json["scenes"][0]["nodes"].push_back(gltf.json["nodes"].size());
    gltf.json["nodes"].push_back(std::move(node));
}

}  // namespace

glm::dquat yaw(double degrees) { return glm::angleAxis(glm::radians(degrees), glm::dvec3(0, 1, 0)); }

size_t Room::addMesh(const Solid& solid, const char* name) {
    Json primitives = Json::array();
    for (const Surface& surface : solid) primitives.push_back(primitiveOf(gltf, surface));
    gltf.json["meshes"].push_back({{"name", name}, {"primitives", primitives}});
    trianglesOfMesh_.push_back(triangleCount(solid));
    return trianglesOfMesh_.size() - 1;
}

void Room::show(size_t mesh, const Pose& pose) {
    Json node = nodeAt(pose);
    node["mesh"] = mesh;
    addNode(gltf, std::move(node));
    trianglesShown_ += trianglesOfMesh_[mesh];
}

void Room::addLight(const Json& light, const Pose& pose) {
    Json& lights = gltf.json["extensions"][kLights]["lights"];
    Json node = nodeAt(pose);
    node["extensions"][kLights]["light"] = lights.size();
    lights.push_back(light);
    addNode(gltf, std::move(node));
}

Image duskImage() {
    constexpr double kPi = double{shared::kPi};
    Image image(128, 64, 3);
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const double up = 0.5 - (y + 0.5) / image.height;                    // in half circles, above the horizon
            const double aside = 2.0 * std::abs((x + 0.5) / image.width - 0.5);  // from where the sun went down
            // A glow at the horizon in front of the window, blue above it, and dark ground.
            const double glow = std::exp(-12.0 * std::abs(up) - 60.0 * aside * aside);
            glm::dvec3 radiance =
                glm::mix(glm::dvec3(0.012, 0.018, 0.035), glm::dvec3(0.002, 0.004, 0.012), 2.0 * std::abs(up));
            radiance += glow * glm::dvec3(1.0, 0.5, 0.32);
            const double crest = 0.01 + 0.006 * std::sin(2 * kPi * 7 * (x + 0.5) / image.width);
            if (up < crest) radiance = glm::dvec3(0.006) + 0.1 * glow * glm::dvec3(0.55, 0.6, 0.9);
            for (uint32_t c = 0; c < 3; ++c) image.at(x, y, c) = static_cast<float>(radiance[static_cast<int>(c)]);
        }
    return image;
}

}  // namespace manylight::showcase
