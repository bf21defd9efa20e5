#include "apps/bench/stability/solids.h"

#include "apps/bench/stability/scenes.h"
#include "engine/scene/generate/courtyard.h"

#include <algorithm>

namespace manylight::stability {

std::vector<Scene> courtyardSolids(size_t count) {
    const Mesh mesh = generateCourtyard({.triangleTarget = 20'000}).mesh;
    std::vector<Scene> solids;
    for (size_t i = 0; i < mesh.objects.size() && solids.size() < count; ++i) {
        if (!mesh.objects[i].closed) continue;
        const size_t end = i + 1 < mesh.objects.size() ? mesh.objects[i + 1].firstFace : mesh.faces.size();
        RawScene raw = emptyScene();
        addMaterial(raw, glm::dvec3(0.5));
        for (size_t f = mesh.objects[i].firstFace; f < end; ++f) {
            const auto& corner = mesh.faces[f].position;
            addTriangle(raw, mesh.positions[corner[0]], mesh.positions[corner[1]], mesh.positions[corner[2]], 0);
            if (mesh.faces[f].cornerCount() == 4)
                addTriangle(raw, mesh.positions[corner[0]], mesh.positions[corner[2]], mesh.positions[corner[3]], 0);
        }
        Scene scene = normalise(std::move(raw));
        const glm::vec3 middle = 0.5f * (scene.boundsMin + scene.boundsMax);
        const bool isStar = std::all_of(scene.triangles.begin(), scene.triangles.end(), [&](const Triangle& t) {
            const glm::vec3 a = scene.vertices[t.vertex[0]].position;
            const glm::vec3 normal =
                glm::cross(scene.vertices[t.vertex[1]].position - a, scene.vertices[t.vertex[2]].position - a);
            return glm::dot(normal, a - middle) > 0.0f;
        });
        if (isStar && scene.triangles.size() >= 12) solids.push_back(std::move(scene));
    }
    return solids;
}

}  // namespace manylight::stability
