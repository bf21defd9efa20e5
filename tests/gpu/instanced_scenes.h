// Scenes of shared meshes, built in code.
#pragma once

#include "tests/gpu/test_scenes.h"

namespace manylight::test {

glm::mat3 turnedBy(float angle, const glm::vec3& axis, const glm::vec3& scale);

/// All triangles since the last mesh become one.
void endMesh(Scene& scene);

void addInstance(Scene& scene, uint32_t mesh, const glm::mat3& sceneFromMesh, const glm::vec3& center);

/// As finished(), by the bounds of the instances.
Scene finishedInstances(Scene scene);

/// sphereInBox()'s room with smooth bodies (turned, scaled, stretched), coloured, culled and cut-out cards, and lamps
/// with a texture, each mesh there several times. Cards and bodies are on no wall.
Scene roomOfInstances();

}  // namespace manylight::test
