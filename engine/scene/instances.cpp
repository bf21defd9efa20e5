#include "engine/scene/instances.h"

#include "engine/core/check.h"
#include "shaders/shared/instance.h"

#include <algorithm>
#include <limits>

namespace manylight {
namespace {

glm::vec3 rowOf(const glm::mat3& m, int row) { return {m[0][row], m[1][row], m[2][row]}; }

/// Vertices that a mesh's triangles use, each once.
std::vector<uint32_t> verticesOf(const Scene& scene, const SharedMesh& mesh) {
    std::vector<uint32_t> vertices;
    vertices.reserve(3 * size_t{mesh.triangleCount});
    for (uint32_t k = 0; k < mesh.triangleCount; ++k)
        for (const uint32_t vertex : scene.triangles[mesh.firstTriangle + k].vertex) vertices.push_back(vertex);
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());  // clang 14 cannot do ranges::unique
    return vertices;
}

glm::vec3 normalInScene(const glm::mat3& m, const glm::vec3& normal) {
    if (normal == glm::vec3(0.0f)) return normal;
    const glm::dmat3 d(m);
    const glm::dmat3 cofactors(glm::cross(d[1], d[2]), glm::cross(d[2], d[0]), glm::cross(d[0], d[1]));
    const double side = glm::determinant(d) < 0.0 ? -1.0 : 1.0;
    return glm::vec3(side * glm::normalize(cofactors * glm::dvec3(normal)));
}

}  // namespace

glm::vec3 placed(const MeshInstance& instance, const glm::vec3& meshPoint) {
    const glm::mat3& m = instance.sceneFromMesh;
    return shared::placedInScene(rowOf(m, 0), rowOf(m, 1), rowOf(m, 2), instance.center, meshPoint);
}

InstanceList listInstances(const Scene& scene) {
    InstanceList list{scene.meshes, scene.instances, {}};
    if (scene.instances.empty()) {
        list.meshes = {{.triangleCount = static_cast<uint32_t>(scene.triangles.size())}};
        list.instances = {MeshInstance{}};
    }
    uint64_t number = 0;
    for (const MeshInstance& instance : list.instances) {
        MANYLIGHT_CHECK(instance.mesh < list.meshes.size(), "instances of {}", scene.path.string());
        list.firstNumbers.push_back(static_cast<uint32_t>(number));
        number += list.meshes[instance.mesh].triangleCount;
        // Pictures name triangles by their number plus one, and rays one more for "none".
        if (number >= std::numeric_limits<uint32_t>::max() - 1)
            fail("{}: more than 2^32 - 2 triangles with all instances of its meshes, which 32 bits cannot number",
                 scene.path.string());
    }
    list.firstNumbers.push_back(static_cast<uint32_t>(number));
    return list;
}

uint64_t shownTriangles(const Scene& scene) {
    if (scene.instances.empty()) return scene.triangles.size();
    uint64_t count = 0;
    for (const MeshInstance& instance : scene.instances) count += scene.meshes[instance.mesh].triangleCount;
    return count;
}

std::vector<Bounds> boundsOfInstances(const Scene& scene, const InstanceList& list) {
    std::vector<std::vector<uint32_t>> vertices(list.meshes.size());
    for (size_t m = 0; m < list.meshes.size(); ++m) vertices[m] = verticesOf(scene, list.meshes[m]);
    std::vector<Bounds> bounds;
    for (const MeshInstance& instance : list.instances) {
        const std::vector<uint32_t>& used = vertices[instance.mesh];
        MANYLIGHT_CHECK(!used.empty(), "a mesh without triangles in {}", scene.path.string());
        Bounds box{glm::vec3(std::numeric_limits<float>::max()), glm::vec3(std::numeric_limits<float>::lowest())};
        for (const uint32_t vertex : used) {
            const glm::vec3 point = placed(instance, scene.vertices[vertex].position);
            box = {glm::min(box.low, point), glm::max(box.high, point)};
        }
        bounds.push_back(box);
    }
    return bounds;
}

void setBounds(Scene& scene, const std::vector<Bounds>& ofInstances) {
    scene.boundsMin = ofInstances.front().low;
    scene.boundsMax = ofInstances.front().high;
    for (const Bounds& bounds : ofInstances) {
        scene.boundsMin = glm::min(scene.boundsMin, bounds.low);
        scene.boundsMax = glm::max(scene.boundsMax, bounds.high);
    }
}

Scene flattened(const Scene& scene) {
    Scene flat = scene;
    if (scene.instances.empty()) return flat;
    const InstanceList list = listInstances(scene);
    flat.meshes.clear();
    flat.instances.clear();
    flat.triangles.clear();
    flat.vertices.clear();
    flat.sharing = {false, "meshes were repeated again", 0};
    for (const MeshInstance& instance : list.instances) {
        const SharedMesh& mesh = list.meshes[instance.mesh];
        const std::vector<uint32_t> used = verticesOf(scene, mesh);
        const auto first = static_cast<uint32_t>(flat.vertices.size());
        for (const uint32_t index : used) {
            Vertex vertex = scene.vertices[index];
            vertex.position = placed(instance, vertex.position);
            vertex.normal = normalInScene(instance.sceneFromMesh, vertex.normal);
            flat.vertices.push_back(vertex);
        }
        for (uint32_t k = 0; k < mesh.triangleCount; ++k) {
            Triangle triangle = scene.triangles[mesh.firstTriangle + k];
            for (uint32_t& vertex : triangle.vertex)
                vertex = first + static_cast<uint32_t>(std::ranges::lower_bound(used, vertex) - used.begin());
            flat.triangles.push_back(triangle);
        }
    }
    return flat;
}

}  // namespace manylight
