// What the showcase's parts share: pictures, materials, and the room that they are put into.
#pragma once

#include "engine/image/image.h"
#include "engine/scene/generate/gltf_text.h"
#include "engine/scene/generate/random.h"
#include "engine/scene/generate/showcase_mesh.h"

#include <glm/gtc/quaternion.hpp>

#include <string>

namespace manylight::showcase {

// Metres; y up, the floor at 0. The camera stands before the front wall and looks through its back.
inline constexpr double kHalfWidth = 2.6;
inline constexpr double kHalfDepth = 2.4;
inline constexpr double kHeight = 2.7;
inline constexpr glm::dvec2 kWindowLow{-1.95, 0.95};  // in the back wall
inline constexpr glm::dvec2 kWindowHigh{-0.25, 2.3};
inline constexpr glm::dvec3 kFloorLamp{0.34, 0.0, -1.95};
inline constexpr double kShadeHeight = 1.42;  // middle of the floor lamp's shade
inline constexpr glm::dvec3 kPainting{1.3, 2.04, -kHalfDepth};
inline constexpr glm::dvec3 kSpot{1.3, 2.56, -1.35};
inline constexpr glm::dvec3 kDownlight{-0.1, kHeight - 0.02, 0.9};

/// 8-bit RGBA texels; a name without extension.
struct Picture {
    std::string name;
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint8_t> rgba;
    bool isTiled = true;
};

/// In the order that the materials of the palette name them in.
enum PictureNumber : int {
    kNoPicture = -1,
    kFloorColour,
    kFloorRoughness,
    kFloorNormal,
    kWallpaper,
    kGrain,
    kWeaveColour,
    kWeaveNormal,
    kBrushed,
    kGauze,
    kLeafShape,
    kRugPattern,
    kEmbroidery,
    kPaperRibs,
    kCanvas,
    kSunset,
    kPictureCount
};

/// Everything that repeats, and everything that is shown once over a surface.
void addTiledPictures(std::vector<Picture>& pictures, uint64_t seed);
void addSinglePictures(std::vector<Picture>& pictures, uint64_t seed);

/// A picture from a colour with opacity for each place in [0, 1] squared, v growing downwards.
Picture painted(const char* name, uint32_t width, uint32_t height,
                const std::function<glm::dvec4(double u, double v)>& colour);

/// Smooth noise in [0, 1] with the given period in both directions.
double noise(double x, double y, uint32_t periodX, uint32_t periodY, uint64_t seed);

/// In the order of the glTF file's materials.
enum MaterialNumber : uint32_t {
    kFloor,
    kWall,
    kCeiling,
    kPaint,
    kWood,
    kFabric,
    kCushion,
    kRug,
    kBrass,
    kGlaze,
    kOrange,
    kLeaf,
    kCurtain,
    kGlass,
    kBook,
    kLantern,
    kShade,
    kBulb,
    kPaintingOnWall,
    kScreen
};

void addMaterials(GltfText& gltf, const std::vector<Picture>& pictures);

/// Where a mesh stands.
struct Pose {
    glm::dvec3 origin{0.0};
    glm::dquat turn{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 scale{1.0};
};

/// About the vertical axis, counter-clockwise seen from above.
glm::dquat yaw(double degrees);

/// The room in the making.
class Room {
  public:
    explicit Room(uint64_t seed) : random(seed) {}

    size_t addMesh(const Solid& solid, const char* name);
    void show(size_t mesh, const Pose& pose);
    void show(const Solid& solid, const char* name, const Pose& pose = {}) { show(addMesh(solid, name), pose); }
    /// Of KHR_lights_punctual; it shines along -z of its pose.
    void addLight(const Json& light, const Pose& pose);
    uint64_t trianglesShown() const { return trianglesShown_; }

    GltfText gltf;
    SceneRandom random;

  private:
    std::vector<size_t> trianglesOfMesh_;
    uint64_t trianglesShown_ = 0;
};

void addWalls(Room& room);
void addWindow(Room& room);
void addSeats(Room& room);
void addTable(Room& room);
void addBookshelf(Room& room);
void addPlant(Room& room);
void addLamps(Room& room);

/// Radiance of a dusk outside.
Image duskImage();

}  // namespace manylight::showcase
