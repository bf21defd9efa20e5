// What an importer read, in the file's own units and in double precision, before normalise() makes a Scene of it.
#pragma once

#include "engine/scene/scene.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace manylight {

struct RawVertex {
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0};  // any length; meaningful if hasNormal
    glm::dvec2 uv{0.0};      // v grows with the image's rows
    glm::dvec2 uv1{0.0};
    glm::dvec4 colour{1.0};
    bool hasNormal = false;
};

/// `origin` is the place in the file: a line of an OBJ file, a running number elsewhere (see RawScene::originLabel).
struct RawTriangle {
    std::array<uint32_t, 3> vertex{};
    uint32_t material = 0;
    uint32_t origin = 0;
};

/// As a file says it, in double precision and not yet checked; `surface` holds the rest. Its own albedo and
/// emissions mean nothing.
struct RawMaterial {
    std::string name;
    glm::dvec3 albedo{0.8};
    glm::dvec3 emittedRadiance{0.0};
    Material surface{};
    float emissionScale = 1.0f;
};

/// The fields of Light in file units; `direction` may have any length.
struct RawLight {
    LightType type = LightType::Point;
    std::string name;
    glm::dvec3 position{0.0};
    glm::dvec3 direction{0.0, -1.0, 0.0};
    glm::dvec3 emission{0.0};
    double cosCutoff = -1.0;
    double cosBeam = -1.0;
    double range = std::numeric_limits<double>::infinity();
};

/// The fields of EnvironmentMap as a file says them: `radiance` is not yet checked, `scale` multiplies it.
struct RawEnvironment {
    std::string name;
    std::filesystem::path file;
    Image radiance;
    glm::dvec3 scale{1.0};
    double turn = 0.0;
};

/// A black quad center +- u +- v that emits towards cross(u, v) only. `u` and `v` are half edges.
struct RawRectLight {
    std::string name;
    glm::dvec3 center{0.0};
    glm::dvec3 u{0.0};
    glm::dvec3 v{0.0};
    glm::dvec3 radiance{0.0};
    float emissionScale = 1.0f;
};

/// `forward` and `up` may have any length and need not be perpendicular.
struct RawCamera {
    std::string name;
    glm::dvec3 origin{0.0};
    glm::dvec3 forward{0.0, 0.0, -1.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    double verticalFov = 0.87;  // radians
    std::optional<glm::uvec2> resolution;
};

/// Triangles that several instances show, in the mesh's own coordinates.
struct RawMesh {
    std::vector<RawVertex> vertices;
    std::vector<RawTriangle> triangles;
};

struct RawInstance {
    uint32_t mesh = 0;
    glm::dmat4 sceneFromMesh{1.0};
};

struct RawScene {
    std::string name;
    std::filesystem::path path;
    std::string originLabel = "triangle";  // what RawTriangle::origin counts: "line" or "triangle"

    std::vector<RawVertex> vertices;
    std::vector<RawTriangle> triangles;
    std::vector<RawMesh> meshes;          // beside `triangles`
    std::vector<RawInstance> instances;   // by mesh; their transforms can be inverted
    std::vector<glm::dvec3> framePoints;  // where things will be at other times: the frame holds them too
    std::vector<double> shape;            // of what an animation deforms: as long as it stays, triangles do
    SharingChoice sharing;
    double animationEnd = 0.0;  // seconds; 0: nothing moves
    std::vector<RawMaterial> materials;
    std::vector<Texture> textures;
    std::vector<RawLight> lights;
    std::vector<RawRectLight> rectLights;
    std::optional<RawEnvironment> environment;
    std::vector<RawCamera> cameras;
    bool lightsAreFinal = false;  // the user listed the lights: add none, even if there are none
    std::optional<int> maxDepth;

    Json settings = Json::object();
    Warnings warnings;
};

}  // namespace manylight
