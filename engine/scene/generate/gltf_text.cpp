#include "engine/scene/generate/gltf_text.h"

#include "engine/scene/generate/generated_scene.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

template <typename T>
size_t addNumbers(GltfText& gltf, const std::vector<T>& values, GltfNumber number, const char* type) {
    return addGltfAccessor(gltf, values.data(), values.size() * sizeof(T), values.size(), number, type);
}

Json materialOf(const MeshMaterial& material) {
    const glm::dvec3& c = material.albedo;
    // Rough and without a specular part: a Lambertian.
    Json json{{"name", material.name},
              {"doubleSided", true},
              {"pbrMetallicRoughness",
               {{"baseColorFactor", {c.r, c.g, c.b, 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 1.0}}},
              {"extensions", {{"KHR_materials_specular", {{"specularFactor", 0.0}}}}}};
    const glm::dvec3& radiance = material.emittedRadiance;
    const double strength = std::max({radiance.r, radiance.g, radiance.b});
    if (strength > 0.0) {
        json["emissiveFactor"] = toJson(radiance / strength);
        json["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", strength}};
    }
    return json;
}

std::vector<uint32_t> cornersOf(const Mesh& mesh, uint32_t material) {
    std::vector<uint32_t> corners;
    for (const MeshFace& face : mesh.faces) {
        if (face.material != material) continue;
        const auto& p = face.position;
        corners.insert(corners.end(), {p[0], p[1], p[2]});
        if (face.cornerCount() == 4) corners.insert(corners.end(), {p[0], p[2], p[3]});
    }
    return corners;
}

}  // namespace

size_t addGltfAccessor(GltfText& gltf, const void* numbers, size_t byteCount, size_t elementCount, GltfNumber number,
                       const char* type) {
    gltf.json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", gltf.bytes.size()}, {"byteLength", byteCount}});
    gltf.bytes.append(static_cast<const char*>(numbers), byteCount);
    gltf.json["accessors"].push_back({{"bufferView", gltf.json["bufferViews"].size() - 1},
                                      {"componentType", number},
                                      {"count", elementCount},
                                      {"type", type}});
    return gltf.json["accessors"].size() - 1;
}

size_t addGltfMesh(GltfText& gltf, const Mesh& mesh, const std::string& name) {
    std::vector<glm::vec3> positions;
    for (const glm::dvec3& p : mesh.positions) positions.emplace_back(p);
    const size_t accessor = addNumbers(gltf, positions, GltfNumber::Float, "VEC3");
    glm::vec3 low = positions.front();
    glm::vec3 high = low;
    for (const glm::vec3& p : positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    gltf.json["accessors"][accessor]["min"] = toJson(low);
    gltf.json["accessors"][accessor]["max"] = toJson(high);
    Json primitives = Json::array();
    for (uint32_t m = 0; m < mesh.materials.size(); ++m) {
        const std::vector<uint32_t> corners = cornersOf(mesh, m);
        if (corners.empty()) continue;
        primitives.push_back({{"attributes", {{"POSITION", accessor}}},
                              {"indices", addNumbers(gltf, corners, GltfNumber::UnsignedInt, "SCALAR")},
                              {"material", gltf.json["materials"].size()}});
        gltf.json["materials"].push_back(materialOf(mesh.materials[m]));
    }
    gltf.json["meshes"].push_back({{"name", name}, {"primitives", primitives}});
    return gltf.json["meshes"].size() - 1;
}

void addGltfNode(GltfText& gltf, size_t mesh, const Placement& place, const glm::dvec3& scale) {
    const double halfYaw = 0.5 * std::atan2(place.sinYaw, place.cosYaw);
    gltf.json["scenes"][0]["nodes"].push_back(gltf.json["nodes"].size());
    gltf.json["nodes"].push_back({{"mesh", mesh},
                                  {"translation", toJson(place.origin)},
                                  {"rotation", {0.0, std::sin(halfYaw), 0.0, std::cos(halfYaw)}},
                                  {"scale", toJson(scale)}});
}

}  // namespace manylight
