// Scenes built by hand, in the normalised frame, for tests that know what the picture must be.
#pragma once

#include "engine/scene/scene.h"

namespace manylight::test {

uint32_t addMaterial(Scene& scene, glm::vec3 albedo, glm::vec3 emittedRadiance = glm::vec3(0.0f));
/// The parallelogram corner + s u + t v; its front is the side that cross(u, v) points to.
void addQuad(Scene& scene, glm::vec3 corner, glm::vec3 u, glm::vec3 v, uint32_t material);
/// A box whose walls face inwards, of one material or of six: -x, +x, -y, +y, -z, +z.
void addRoom(Scene& scene, glm::vec3 low, glm::vec3 high, const std::array<uint32_t, 6>& materials);
void addRoom(Scene& scene, glm::vec3 low, glm::vec3 high, uint32_t material);
/// An octahedron divided `levels` times and blown up to a sphere; `inwards` turns its front side to the centre.
void addSphere(Scene& scene, glm::vec3 center, float radius, int levels, bool inwards, bool smooth, uint32_t material);
void addCamera(Scene& scene, glm::vec3 origin, glm::vec3 target, float verticalFov);

Light pointLight(glm::vec3 position, glm::vec3 intensity);
Light spotLight(glm::vec3 position, glm::vec3 direction, glm::vec3 intensity, float beamAngle, float cutoffAngle);
Light directionalLight(glm::vec3 direction, glm::vec3 irradiance);
Light constantLight(glm::vec3 radiance);

/// Computes the bounds. The diagonal must be in [1, 2), as normalise() would leave it.
Scene finished(Scene scene);

/// The cube [-0.5, 0.5]^3 seen from inside, without lights.
Scene closedBox(glm::vec3 albedo, glm::vec3 emittedRadiance = glm::vec3(0.0f));
/// Closed, with walls of different albedos.
Scene unevenBox();
/// The square [-0.5, 0.5]^2 at y = 0, front side up, and a camera above that sees nothing else.
Scene floorFromAbove(float albedo);
/// A room with a smooth sphere, textured walls, and every kind of light.
Scene everyKindOfLight();
/// A closed room with an area light, a point light, and a sphere in it, off the walls: unbounded, G scatters less.
Scene sphereInBox();
/// Two rooms, the camera in one and the lamp in the other: all light comes by way of the door.
Scene twoRooms();
/// The box of sphereInBox() with a smooth sphere and two walls of rough metal and a floor of varnish.
Scene glossyRoom();
/// sphereInBox() with a lamp whose emission is a texture, an unlit card and walls of many colours.
Scene patternedRoom();
/// sphereInBox() with a card of which three tenths are not there, and a grating.
Scene translucentRoom();
/// sphereInBox() with bumpy walls.
Scene bumpyRoom();
/// The scene of scenes/cornell_box.json.
Scene cornellBox();

}  // namespace manylight::test
