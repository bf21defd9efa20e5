// Scene: plain data, in the normalised frame, known to no Vulkan. The importers make it, everything else reads it.
#pragma once

#include "engine/core/report.h"
#include "engine/image/image.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace manylight {

/// scenePoint = center + 2^exponent * normalisedPoint. The diagonal of the normalised bounds is in [1, 2).
/// Directions and radiance are the same in both frames; an intensity (W/sr) scales by 4^-exponent on the way in.
struct SceneFrame {
    glm::dvec3 center{0.0};
    int exponent = 0;
};

enum class TextureWrap : uint8_t { Repeat, ClampToEdge, MirroredRepeat };
enum class TextureFilter : uint8_t { Linear, Nearest };

/// 8-bit RGBA texels, row 0 at v = 0 (the importers flip OBJ images, whose v points up). Whether rgb is sRGB encoded is
/// up to the use; alpha is linear.
struct Texture {
    std::string name;
    uint32_t width = 0;
    uint32_t height = 0;
    TextureWrap wrapU = TextureWrap::Repeat;
    TextureWrap wrapV = TextureWrap::Repeat;
    TextureFilter filter = TextureFilter::Linear;  // of a texture that is seen from near
    bool isMipmapped = false;                      // smaller versions of it stand for what is seen from afar
    std::vector<uint8_t> rgba;  // width * height * 4
};

inline constexpr int32_t kNoTexture = -1;

/// How a material looks a texture up: at uvMatrix * uv + uvOffset, uv being the vertices' set number `uvSet`.
struct TextureUse {
    int32_t texture = kNoTexture;  // index into Scene::textures
    uint32_t uvSet = 0;            // 0 or 1
    glm::mat2 uvMatrix{1.0f};
    glm::vec2 uvOffset{0.0f};

    bool exists() const { return texture != kNoTexture; }
};

enum class AlphaMode : uint8_t { Opaque, Mask, Blend };

/// A two-sided reflector that may also emit from its front (counter-clockwise) side. Metallic-roughness as in glTF 2.0;
/// as it is by default, a Lambertian.
struct Material {
    std::string name;
    glm::vec3 albedo{0.8f};      // linear, in [0, 1]: reflectance of the diffuse part, at normal incidence of a metal
    TextureUse albedoTexture{};  // sRGB, multiplies it
    glm::vec3 emittedRadiance{0.0f};  // W / (sr m^2), front side only
    TextureUse emissionTexture{};     // sRGB, multiplies it

    float metallic = 0.0f;                  // share of the surface that is metal
    float roughness = 1.0f;                 // perceptual: GGX's alpha is its square
    TextureUse metallicRoughnessTexture{};  // linear: green multiplies roughness, blue metallic
    glm::vec3 specular{0.0f};               // reflectance at normal incidence of what is not metal; 0: Lambertian
    TextureUse normalTexture{};             // linear: 2 rgb - 1 in the frame of the texture's u, v and the normal
    float normalScale = 1.0f;               // multiplies its first two components

    AlphaMode alphaMode = AlphaMode::Opaque;
    float opacity = 1.0f;         // where not opaque: Mask hides what is below `alphaCutoff`, Blend shows that share
    TextureUse opacityTexture{};  // its alpha channel multiplies `opacity`
    float alphaCutoff = 0.5f;
    bool culled = false;  // the camera looks through its back, which light does not: single-sided as in glTF
    bool unlit = false;   // shows its albedo as radiance to the camera, and is black and dark to everything else

    // emittedRadiance is emissionScale * givenRadiance: see scaleEmission().
    glm::vec3 givenRadiance{0.0f};  // as the scene file has it
    float emissionScale = 1.0f;     // the user's
};

/// Three corners of unified vertices plus a material: indices into Scene::vertices and Scene::materials.
struct Triangle {
    std::array<uint32_t, 3> vertex{};
    uint32_t material = 0;
};

/// `normal` is a unit shading normal, or zero where the file has none: then the triangle is flat.
struct Vertex {
    glm::vec3 position{0.0f};  // normalised frame
    glm::vec3 normal{0.0f};
    glm::vec2 uv{0.0f};  // v grows with the image's rows
    glm::vec2 uv1{0.0f};
    glm::vec4 colour{1.0f};  // linear, in [0, 1]; multiplies the material's albedo and opacity
};

/// Triangles that instances show, in a frame of the mesh's own.
struct SharedMesh {
    uint32_t firstTriangle = 0;
    uint32_t triangleCount = 0;
    SceneFrame frame{};  // from there to the mesh's coordinates in the file
};

inline constexpr uint32_t kNoSource = 0xffffffffu;  // MeshInstance::source of what is no instance in the file

/// A mesh in the scene: scenePoint = sceneFromMesh * meshPoint + center. A mesh that some instances mirror exists
/// twice, so that triangles are counter-clockwise from their front in the scene.
struct MeshInstance {
    uint32_t mesh = 0;  // index into Scene::meshes
    glm::mat3 sceneFromMesh{1.0f};
    glm::vec3 center{0.0f};
    uint32_t source = 0;  // which of the instances in the file
};

/// Whether meshes that are shown several times are kept once, and why; `savedBytes` of device memory.
struct SharingChoice {
    bool shares = false;
    std::string reason = "no mesh is shown twice";
    uint64_t savedBytes = 0;
};

enum class LightType : uint8_t { Point, Spot, Directional, Constant };

/// A light that is no surface. Emissive triangles are lights too, through their material; a sidecar's rect_area
/// becomes two such triangles with a black material.
struct Light {
    LightType type = LightType::Point;
    std::string name;
    glm::vec3 position{0.0f};          // normalised frame; point, spot
    glm::vec3 direction{0.0f, -1, 0};  // unit, of travel; spot, directional
    /// Point, spot: radiant intensity in the normalised frame. Directional: irradiance on a perpendicular plane.
    /// Constant: radiance of the surroundings.
    glm::vec3 emission{0.0f};
    float cosCutoff = -1.0f;  // spot: dark outside; linear in angle between beam and cutoff
    float cosBeam = -1.0f;    // spot: full intensity inside
    /// Point, spot: normalised frame; irradiance falls to zero at this distance, as rangeWindow() in
    /// shaders/lib/range.glsl has it.
    float range = std::numeric_limits<float>::infinity();
};

/// Surroundings that differ with the direction. Adds to lights of type Constant.
struct EnvironmentMap {
    std::string name;
    /// Three channels of radiance, finite and not negative. Equirectangular: rows run from +Y down to -Y; without a
    /// turn the middle of a row is at -Z and what is right of it at +X, as a camera that looks along -Z sees it.
    Image radiance;
    float turn = 0.0f;  // about +Y, counter-clockwise seen from above, as a share of a circle
};

/// Pinhole. All vectors in the normalised frame; `forward` and `up` are unit and perpendicular.
struct Camera {
    std::string name;
    glm::vec3 origin{0.0f};
    glm::vec3 forward{0.0f, 0.0f, -1.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    float verticalFov = 0.7853982f;        // radians
    std::optional<glm::uvec2> resolution;  // width, height, where the file names one
};

struct Scene {
    std::string name;
    std::filesystem::path path;  // what the user asked for
    SceneFrame frame;
    glm::vec3 boundsMin{0.0f};  // of the triangles, normalised frame
    glm::vec3 boundsMax{0.0f};

    std::vector<Vertex> vertices;
    std::vector<Triangle> triangles;
    std::vector<SharedMesh> meshes;       // of `triangles`, if there are instances
    std::vector<MeshInstance> instances;  // by mesh; none: `triangles` are in the scene's frame, each there once
    SharingChoice sharing;
    double animationEnd = 0.0;        // seconds of the file's animation; 0: none was asked for, or nothing moves
    std::vector<Material> materials;  // at least one if there are triangles
    std::vector<Texture> textures;
    std::vector<Light> lights;
    std::optional<EnvironmentMap> environment;
    std::vector<Camera> cameras;  // at least one: the importer adds a default and says so
    std::optional<int> maxDepth;  // sidecar's max_depth: -1 unlimited, 1 emission, 2 direct, 3 one bounce

    Json settings = Json::object();      // sidecar's "settings": defaults for the command line's options
    Json importReport = Json::object();  // counts of what was read
    Warnings warnings;                   // everything dropped or repaired
};

}  // namespace manylight
