// Scenes of instances: what is where.
#pragma once

#include "engine/scene/scene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace manylight {

/// Where an instance puts a point of its mesh: the same bits as on the device.
glm::vec3 placed(const MeshInstance& instance, const glm::vec3& meshPoint);

/// Meshes and instances of any scene: one without instances is one mesh, where it is.
struct InstanceList {
    std::vector<SharedMesh> meshes;
    std::vector<MeshInstance> instances;
    std::vector<uint32_t> firstNumbers;  // of each instance's triangles, numbered through all; then their count

    uint32_t triangleCount() const { return firstNumbers.back(); }
};
/// Throws Error if the scene has more triangles than a 32-bit number can tell apart.
InstanceList listInstances(const Scene& scene);

/// Triangles with all repeats.
uint64_t shownTriangles(const Scene& scene);

struct Bounds {
    glm::vec3 low{0.0f};
    glm::vec3 high{0.0f};
};
/// Of every instance, in the scene's frame.
std::vector<Bounds> boundsOfInstances(const Scene& scene, const InstanceList& list);
/// Of everything, once the instances have their places.
void setBounds(Scene& scene, const std::vector<Bounds>& ofInstances);

/// The same scene with every triangle there once for each instance that shows it, and no instances.
Scene flattened(const Scene& scene);

/// Calls visit(number, triangle, corners in the scene's frame) for every triangle of every instance.
template <typename Visit>
void forEachTriangle(const Scene& scene, const InstanceList& list, const Visit& visit) {
    for (size_t i = 0; i < list.instances.size(); ++i) {
        const MeshInstance& instance = list.instances[i];
        const SharedMesh& mesh = list.meshes[instance.mesh];
        for (uint32_t k = 0; k < mesh.triangleCount; ++k) {
            const Triangle& triangle = scene.triangles[mesh.firstTriangle + k];
            std::array<glm::vec3, 3> corners{};
            for (size_t c = 0; c < 3; ++c) corners[c] = placed(instance, scene.vertices[triangle.vertex[c]].position);
            visit(list.firstNumbers[i] + k, triangle, corners);
        }
    }
}

}  // namespace manylight
