#include "engine/scene/generate/mesh.h"

#include <cmath>

namespace manylight {

namespace {

constexpr double kGrid = 1e5;  // vertices lie on multiples of its inverse

double roundToGrid(double value) { return std::round(value * kGrid) / kGrid + 0.0; }

}  // namespace

Placement turned(const glm::dvec3& origin, double yaw) { return {origin, std::cos(yaw), std::sin(yaw)}; }

void beginObject(Mesh& mesh, std::string name, bool closed) {
    mesh.objects.push_back({std::move(name), mesh.faces.size(), closed});
}

uint32_t addMaterial(Mesh& mesh, std::string name, const glm::dvec3& albedo, const glm::dvec3& emittedRadiance) {
    mesh.materials.push_back({std::move(name), albedo, emittedRadiance});
    return static_cast<uint32_t>(mesh.materials.size() - 1);
}

uint32_t addPosition(Mesh& mesh, const glm::dvec3& position) {
    mesh.positions.emplace_back(roundToGrid(position.x), roundToGrid(position.y), roundToGrid(position.z));
    return static_cast<uint32_t>(mesh.positions.size() - 1);
}

uint32_t addNormal(Mesh& mesh, const glm::dvec3& normal) {
    const glm::dvec3 unit = glm::normalize(normal);
    mesh.normals.emplace_back(roundToGrid(unit.x), roundToGrid(unit.y), roundToGrid(unit.z));
    return static_cast<uint32_t>(mesh.normals.size() - 1);
}

void addTriangle(Mesh& mesh, uint32_t material, uint32_t a, uint32_t b, uint32_t c) {
    mesh.faces.push_back({.position = {a, b, c, kNoIndex}, .material = material});
}

void addQuad(Mesh& mesh, uint32_t material, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    mesh.faces.push_back({.position = {a, b, c, d}, .material = material});
}

void addQuad(Mesh& mesh, uint32_t material, const std::array<glm::dvec3, 4>& corners) {
    std::array<uint32_t, 4> index{};
    for (size_t i = 0; i < 4; ++i) index[i] = addPosition(mesh, corners[i]);
    addQuad(mesh, material, index[0], index[1], index[2], index[3]);
}

size_t triangleCount(const Mesh& mesh) {
    size_t count = 0;
    for (const MeshFace& face : mesh.faces) count += face.cornerCount() - 2;
    return count;
}

}  // namespace manylight
