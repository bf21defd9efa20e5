#include "engine/scene/sidecar.h"

#include "engine/core/file.h"
#include "engine/image/image_io.h"
#include "engine/scene/emission_scale.h"
#include "engine/scene/json_view.h"
#include "engine/scene/scene_file.h"

#include <cmath>
#include <limits>

namespace manylight {
namespace {

constexpr int kLargestSide = 1 << 16;
constexpr int kLargestDepth = 1 << 20;
constexpr size_t kMostEnvironmentTexels = size_t{1} << 25;  // half a gigabyte on the device

double angle(const JsonView& degrees, double least, double most) {
    const double value = degrees.number();
    if (!(value >= least && value <= most)) degrees.failExpected(fmt::format("degrees in [{}, {}]", least, most));
    return glm::radians(value);
}

glm::dvec3 nonZero3(const JsonView& view) {
    const glm::dvec3 v = view.vector3();
    if (v == glm::dvec3(0.0)) view.failExpected("a vector that is not zero");
    return v;
}

std::string optionalName(const JsonView& view, std::string fallback) {
    return view.has("name") ? view.at("name").text() : std::move(fallback);
}

RawCamera readCamera(const JsonView& view) {
    view.expectKeys({"name", "origin", "target", "up", "fov_y_deg", "width", "height"});
    RawCamera camera;
    camera.name = optionalName(view, "sidecar");
    camera.origin = view.at("origin").vector3();
    camera.forward = view.at("target").vector3() - camera.origin;
    if (view.has("up")) camera.up = nonZero3(view.at("up"));
    if (camera.forward == glm::dvec3(0.0)) view.at("target").failExpected("a point other than the origin");
    if (glm::length(glm::cross(glm::normalize(camera.forward), glm::normalize(camera.up))) < 1e-9)
        view.failExpected("an up vector that is not along the view");
    camera.verticalFov = angle(view.at("fov_y_deg"), 0.001, 179.0);
    if (view.has("width") || view.has("height"))
        camera.resolution =
            glm::uvec2(view.at("width").integer(1, kLargestSide), view.at("height").integer(1, kLargestSide));
    return camera;
}

double readRange(const JsonView& view) {
    return view.has("range") ? view.at("range").positiveNumber() : std::numeric_limits<double>::infinity();
}

RawLight readSpot(const JsonView& view) {
    view.expectKeys({"type", "name", "position", "direction", "cutoff_deg", "beam_deg", "intensity", "range"});
    const double cutoff = angle(view.at("cutoff_deg"), 0.001, 180.0);
    const double beam = angle(view.at("beam_deg"), 0.0, 180.0);
    if (beam > cutoff) view.at("beam_deg").failExpected("an angle no larger than cutoff_deg");
    return {.type = LightType::Spot,
            .name = {},
            .position = view.at("position").vector3(),
            .direction = nonZero3(view.at("direction")),
            .emission = view.at("intensity").nonNegative3(),
            .cosCutoff = std::cos(cutoff),
            .cosBeam = std::cos(beam),
            .range = readRange(view)};
}

RawRectLight readRectLight(const JsonView& view) {
    view.expectKeys({"type", "name", "center", "u", "v", "radiance"});
    RawRectLight rect{.name = {},
                      .center = view.at("center").vector3(),
                      .u = nonZero3(view.at("u")),
                      .v = nonZero3(view.at("v")),
                      .radiance = view.at("radiance").nonNegative3()};
    if (glm::cross(glm::normalize(rect.u), glm::normalize(rect.v)) == glm::dvec3(0.0))
        view.failExpected("half edges u and v that are not parallel");
    return rect;
}

/// All but the image, which is read last: see readEnvironmentImage().
RawEnvironment readEnvironment(const JsonView& view, const std::filesystem::path& folder) {
    view.expectKeys({"type", "name", "image", "scale", "rotation_deg"});
    RawEnvironment environment;
    environment.file = folder / view.at("image").text();
    std::error_code refused;  // a name may be longer than the system takes
    if (!std::filesystem::is_regular_file(environment.file, refused)) view.at("image").failExpected("an existing file");
    if (view.has("scale")) environment.scale = view.at("scale").nonNegative3();
    if (view.has("rotation_deg")) environment.turn = view.at("rotation_deg").number() / 360.0;
    return environment;
}

Image readEnvironmentImage(const std::filesystem::path& file) {
    Image image = readRadianceMap(file);
    if (size_t{image.width} * image.height > kMostEnvironmentTexels)
        fail("{}: {} x {} texels, expected {} at most of an environment map", file.string(), image.width, image.height,
             kMostEnvironmentTexels);
    return image;
}

void readLight(const JsonView& view, size_t index, RawScene& scene) {
    const std::string type = view.at("type").text();
    const std::string name = optionalName(view, fmt::format("{} {}", type, index));
    if (type == "rect_area") {
        scene.rectLights.push_back(readRectLight(view));
        scene.rectLights.back().name = name;
        return;
    }
    if (type == "environment") {
        if (scene.environment) view.at("type").failExpected("no second environment");
        scene.environment = readEnvironment(view, std::filesystem::path(view.file()).parent_path());
        scene.environment->name = name;
        return;
    }
    RawLight light;
    if (type == "point") {
        view.expectKeys({"type", "name", "position", "intensity", "range"});
        light.position = view.at("position").vector3();
        light.emission = view.at("intensity").nonNegative3();
        light.range = readRange(view);
    } else if (type == "spot") {
        light = readSpot(view);
    } else if (type == "directional") {
        view.expectKeys({"type", "name", "direction", "irradiance"});
        light.type = LightType::Directional;
        light.direction = nonZero3(view.at("direction"));
        light.emission = view.at("irradiance").nonNegative3();
    } else if (type == "constant") {
        view.expectKeys({"type", "name", "radiance"});
        light.type = LightType::Constant;
        light.emission = view.at("radiance").nonNegative3();
    } else {
        view.at("type").failExpected("point, spot, directional, rect_area, constant or environment");
    }
    light.name = name;
    scene.lights.push_back(std::move(light));
}

void replaceLights(const JsonView& root, RawScene& scene) {
    const bool listsLights = root.has("lights");
    const bool keepsLights = root.has("use_gltf_lights") ? root.at("use_gltf_lights").boolean() : !listsLights;
    if (!keepsLights) scene.lights.clear();
    if (!listsLights) return;
    const JsonView lights = root.at("lights").expectArray();
    for (size_t i = 0; i < lights.size(); ++i) readLight(lights.at(i), i, scene);
    scene.lightsAreFinal = true;
}

int readMaxDepth(const JsonView& view) {
    const auto depth = static_cast<int>(view.integer(-1, kLargestDepth));
    if (depth == 0) view.failExpected("-1 (unlimited) or at least 1 (emission only)");
    return depth;
}

std::optional<double> readMoment(const JsonView& root) {
    if (!root.has("at")) return std::nullopt;
    const double moment = root.at("at").number();
    if (!(moment >= 0.0)) root.at("at").failExpected("seconds, 0 or more");
    return moment;
}

float readEmissionScale(const JsonView& view) {
    const double scale = view.number();
    if (!(scale >= 0.0 && scale <= double{kLargestEmissionScale}))
        view.failExpected(fmt::format("a factor in [0, {}]", kLargestEmissionScale));
    return static_cast<float>(scale);
}

/// Of surfaces, by the names of their materials.
void scaleEmissions(const JsonView& emissions, RawScene& scene) {
    for (const auto& emission : emissions.expectObject().json().items()) {
        const std::string& name = emission.key();
        const float scale = readEmissionScale(emissions.at(name));
        bool isFound = false;
        const auto take = [&](auto& surfaces) {
            for (auto& surface : surfaces)
                if (surface.name == name) surface.emissionScale = scale, isFound = true;
        };
        take(scene.materials);
        take(scene.rectLights);
        if (!isFound) emissions.at(name).failExpected("the name of a material, or of a rect_area");
    }
}

/// Everything but the scene file itself, so that a mistake in the sidecar is told before a large file is read.
RawScene readOwnKeys(const JsonView& root) {
    root.expectKeys(
        {"name", "scene", "max_depth", "camera", "lights", "use_gltf_lights", "emission", "at", "settings"});
    RawScene own;
    if (root.has("name")) own.name = root.at("name").text();
    if (root.has("max_depth")) own.maxDepth = readMaxDepth(root.at("max_depth"));
    if (root.has("camera")) own.cameras.push_back(readCamera(root.at("camera")));
    if (root.has("settings")) own.settings = root.at("settings").expectObject().json();
    replaceLights(root, own);
    if (root.has("emission"))
        for (const auto& [name, value] : root.at("emission").expectObject().json().items())
            readEmissionScale(root.at("emission").at(name));
    readMoment(root);
    return own;
}

}  // namespace

std::optional<double> savedMoment(const std::filesystem::path& path) {
    if (sceneFileKind(path) != SceneFileKind::Sidecar) return std::nullopt;
    const std::string file = path.string();
    const Json json = parseJson(readTextFile(path), file);
    return readMoment(JsonView(json, file).expectObject());
}

RawScene readSidecar(const std::filesystem::path& path, const ImportOptions& options) {
    const std::string file = path.string();
    const Json json = parseJson(readTextFile(path), file);
    const JsonView root(json, file);
    RawScene own = readOwnKeys(root);

    const std::filesystem::path named = path.parent_path() / root.at("scene").text();
    if (sceneFileKind(named) == SceneFileKind::Sidecar)
        root.at("scene").failExpected("a scene file (.obj, .gltf, .glb), not another sidecar");
    std::error_code refused;  // a name may be longer than the system takes
    if (!std::filesystem::exists(named, refused)) root.at("scene").failExpected("an existing file");

    ImportOptions ofFile = options;
    if (!options.time) ofFile.time = readMoment(root);
    RawScene scene = readSceneFile(named, ofFile);
    if (root.has("at") && scene.animationEnd <= 0.0)
        scene.warnings.add("moments of an animation ignored: nothing moves", root.at("at").place());
    if (!own.name.empty()) scene.name = std::move(own.name);
    scene.path = path;
    scene.maxDepth = own.maxDepth;
    scene.settings = std::move(own.settings);
    if (!own.cameras.empty()) scene.cameras = std::move(own.cameras);
    replaceLights(root, scene);
    if (options.placesOnly) return scene;
    if (root.has("emission")) scaleEmissions(root.at("emission"), scene);
    if (scene.environment) scene.environment->radiance = readEnvironmentImage(scene.environment->file);
    return scene;
}

}  // namespace manylight
