#include "engine/scene/generate/showcase.h"

#include "engine/core/file.h"
#include "engine/image/image_io.h"
#include "engine/scene/generate/generated_scene.h"
#include "engine/scene/generate/showcase_parts.h"

#include <cmath>

namespace manylight {
namespace {

using namespace showcase;

/// Light through the shade's openings, on the painting, and from the ceiling.
void addLights(Room& room) {
    room.addLight({{"type", "point"}, {"name", "floor lamp"}, {"color", {1.0, 0.72, 0.42}}, {"intensity", 4.0}},
                  {kFloorLamp + glm::dvec3(0.0, kShadeHeight, 0.0)});
    const glm::dvec3 toPainting = kPainting - kSpot;
    const double down = std::atan2(-toPainting.y, -toPainting.z);
    room.addLight({{"type", "spot"},
                   {"name", "painting"},
                   {"color", {1.0, 0.86, 0.66}},
                   {"intensity", 8.0},
                   {"spot", {{"innerConeAngle", 0.3}, {"outerConeAngle", 0.6}}}},
                  {kSpot, glm::angleAxis(-down, glm::dvec3(1, 0, 0))});
    room.addLight({{"type", "spot"},
                   {"name", "ceiling"},
                   {"color", {1.0, 0.87, 0.7}},
                   {"intensity", 11.0},
                   {"spot", {{"innerConeAngle", 0.8}, {"outerConeAngle", 1.4}}}},
                  {kDownlight, glm::angleAxis(glm::radians(-90.0), glm::dvec3(1, 0, 0))});
}

Json sidecar() {
    return {{"name", "showcase"},
            {"scene", "showcase/showcase.gltf"},
            {"camera",
             {{"origin", {0.25, 1.5, 4.1}},
              {"target", {-0.02, 1.08, -1.5}},
              {"fov_y_deg", 44.0},
              {"width", 320},
              {"height", 240}}},
            {"use_gltf_lights", true},
            {"lights", {{{"type", "environment"}, {"name", "dusk"}, {"image", "showcase/dusk.exr"}}}}};
}

}  // namespace

ShowcaseFiles writeShowcase(const ShowcaseParameters& parameters, const std::filesystem::path& folder) {
    std::vector<Picture> pictures;
    addTiledPictures(pictures, parameters.seed);
    addSinglePictures(pictures, parameters.seed);

    Room room(parameters.seed);
    room.gltf.json["extensionsUsed"] = {"KHR_materials_emissive_strength", "KHR_materials_unlit",
                                        "KHR_texture_transform", "KHR_lights_punctual"};
    addMaterials(room.gltf, pictures);
    addWalls(room);
    addWindow(room);
    addSeats(room);
    addTable(room);
    addBookshelf(room);
    addPlant(room);
    addLamps(room);
    addLights(room);
    room.gltf.json["buffers"] = {{{"byteLength", room.gltf.bytes.size()}, {"uri", "showcase.bin"}}};

    const std::filesystem::path inside = folder / "showcase";
    createSceneFolder(inside);
    ShowcaseFiles files;
    files.trianglesShown = room.trianglesShown();
    const auto add = [&](const std::filesystem::path& path) -> const std::filesystem::path& {
        return files.written.emplace_back(path);
    };
    for (const Picture& picture : pictures)
        writePngRgba8(add(inside / (picture.name + ".png")), picture.width, picture.height, picture.rgba);
    writeExr(add(inside / "dusk.exr"), {{"", {"R", "G", "B"}, duskImage()}}, {});
    writeTextFile(add(inside / "showcase.bin"), room.gltf.bytes);
    writeTextFile(add(inside / "showcase.gltf"), room.gltf.json.dump() + "\n");
    writeTextFile(add(folder / "showcase.json"), sidecar().dump(2) + "\n");
    return files;
}

}  // namespace manylight
