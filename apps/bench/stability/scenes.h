// Scenes of the stability suite, as an importer would read them: normalise() is part of what is tried.
#pragma once

#include "engine/scene/normalise.h"

namespace manylight::stability {

uint32_t addMaterial(RawScene& raw, glm::dvec3 albedo, glm::dvec3 emittedRadiance = glm::dvec3(0.0));
void addTriangle(RawScene& raw, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, uint32_t material);
/// The parallelogram corner + s u + t v, divided into `cells` by `cells` pairs of triangles; its front is the side that
/// cross(u, v) points to.
void addQuad(RawScene& raw, glm::dvec3 corner, glm::dvec3 u, glm::dvec3 v, uint32_t material, uint32_t cells = 1);
/// A box whose walls face inwards.
void addRoom(RawScene& raw, glm::dvec3 low, glm::dvec3 high, uint32_t material, uint32_t cells = 1);
/// An octahedron divided `levels` times and blown up to a sphere; `inwards` turns its front side to the centre.
void addSphere(RawScene& raw, glm::dvec3 center, double radius, int levels, bool inwards, bool smooth,
               uint32_t material);
void addCamera(RawScene& raw, glm::dvec3 origin, glm::dvec3 target, double verticalFov);
void addPointLight(RawScene& raw, glm::dvec3 position, glm::dvec3 intensity);
/// All its light within `cutoff` of `direction`, equally strong.
void addSpotLight(RawScene& raw, glm::dvec3 position, glm::dvec3 direction, glm::dvec3 intensity, double cutoff);

/// No lights beyond those listed.
RawScene emptyScene();
/// The closed cube [-0.5, 0.5]^3 of one material, seen from inside.
RawScene closedRoom(double albedo, double emittedRadiance = 0.0);
/// A room with walls of three colours, a tilted card, a smooth sphere, a lamp of finite size and a point light.
RawScene furnishedRoom();

/// The same scene in another unit: lengths times `factor`, intensities times its square.
RawScene inUnit(RawScene raw, double factor);
RawScene movedBy(RawScene raw, glm::dvec3 offset);
/// All light times 2^exponent.
RawScene withLight(RawScene raw, int exponent);

}  // namespace manylight::stability
