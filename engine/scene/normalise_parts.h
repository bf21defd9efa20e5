// The phases of normalise(): not for use elsewhere.
#pragma once

#include "engine/scene/raw_scene.h"

namespace manylight {

glm::vec3 normalisedPoint(const SceneFrame& frame, const glm::dvec3& point);

/// Radiance, irradiance or intensity must be finite and at least zero in every channel. Others become zero, counted.
glm::vec3 repairedEmission(const glm::dvec3& emission, const std::string& name, Warnings& warnings);

/// Instances at the raw scene's places, in a scene that has its frame and meshes. By mesh; others stay behind them.
void placeInstances(const RawScene& raw, Scene& scene);

/// `points` in the file's coordinates.
void includeInBounds(Scene& scene, const std::vector<glm::dvec3>& points);

void convertMaterials(const RawScene& raw, Scene& scene);
void convertLights(const RawScene& raw, Scene& scene);
/// An environment map without light is left out, counted.
void convertEnvironment(const RawScene& raw, Scene& scene);
void convertCameras(const RawScene& raw, Scene& scene);

/// A view of the whole bounds, if the scene has no camera.
void addMissingCamera(Scene& scene);
/// A point light near the first camera, if nothing in the scene emits.
void addMissingLight(Scene& scene);
/// A warning if nothing in the scene emits.
void reportMissingLight(Scene& scene);
void fillImportReport(Scene& scene, size_t trianglesRead);

}  // namespace manylight
