#include "engine/scene/generate/cube.h"

#include "engine/scene/generate/shapes.h"

namespace manylight {

GeneratedScene generateCube() {
    GeneratedScene scene;
    scene.name = "cube";
    scene.comments = {"A unit cube of quads. The material file is missing and there are no normals, on purpose."};
    scene.hasMaterialFile = false;

    // A box made in one go, then split: one group per face.
    Mesh& mesh = scene.mesh;
    const uint32_t material = addMaterial(mesh, "cube", glm::dvec3(0.8));
    addBox(mesh, {}, glm::dvec3(-0.5), glm::dvec3(0.5), material);
    const char* const names[] = {"back", "front", "left", "right", "bottom", "top"};
    for (size_t i = 0; i < mesh.faces.size(); ++i) mesh.objects.push_back({names[i], i, false});

    scene.sidecar["camera"] = {{"origin", {-0.42, 0.1, 0.45}},
                               {"target", {0.2, -0.1, -0.35}},
                               {"up", {0, 1, 0}},
                               {"fov_y_deg", 70},
                               {"width", 512},
                               {"height", 384}};
    scene.sidecar["lights"] = Json::array(
        {{{"type", "point"}, {"name", "bulb"}, {"position", {0.1, 0.2, -0.1}}, {"intensity", {0.1, 0.09, 0.075}}}});
    scene.sidecar["max_depth"] = -1;
    return scene;
}

}  // namespace manylight
