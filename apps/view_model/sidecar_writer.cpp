#include "apps/view_model/sidecar_writer.h"

#include "engine/core/file.h"
#include "engine/scene/emission_scale.h"
#include "engine/scene/json_view.h"
#include "engine/scene/scene_file.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

namespace fs = std::filesystem;

Json vectorJson(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

fs::path relativeTo(const fs::path& file, const fs::path& folder) {
    const fs::path relative = fs::absolute(file).lexically_relative(fs::absolute(folder));
    return relative.empty() ? fs::absolute(file) : relative;
}

/// The lights that a sidecar lists, with names that do not depend on their places and images as seen from `folder`.
Json listedLights(const Json& sidecar, const fs::path& from, const fs::path& folder) {
    Json lights = sidecar.value("lights", Json::array());
    for (size_t i = 0; i < lights.size(); ++i) {
        Json& light = lights[i];
        if (!light.contains("name")) light["name"] = fmt::format("{} {}", light.value("type", ""), i);
        if (light.contains("image"))
            light["image"] = relativeTo(from / light["image"].get<std::string>(), folder).generic_string();
    }
    return lights;
}

/// Lights of the scene as they are now, and those of the old list that are no such lights: rectangles are surfaces.
Json changedLights(const Scene& scene, const Json& listed) {
    Json lights = Json::array();
    for (const Light& light : scene.lights) lights.push_back(lightJson(light, scene.frame));
    for (const Json& light : listed)
        if (light.value("type", "") == "rect_area" || light.value("type", "") == "environment") lights.push_back(light);
    return lights;
}

Json emissionJson(const Scene& scene) {
    Json scales = Json::object();
    for (const SurfaceEmitter& emitter : surfaceEmitters(scene))
        if (emitter.scale != 1.0f) scales[emitter.material] = emitter.scale;
    return scales;
}

/// A key that says nothing is left out.
void setOrErase(Json& json, const char* key, const Json& value) {
    if (value.empty())
        json.erase(key);
    else
        json[key] = value;
}

}  // namespace

Json lightJson(const Light& light, const SceneFrame& frame) {
    const double unit = std::ldexp(1.0, frame.exponent);
    const Json position = vectorJson(frame.center + unit * glm::dvec3(light.position));
    const Json intensity = vectorJson(unit * unit * glm::dvec3(light.emission));
    Json json = {{"type", "point"}};
    if (!light.name.empty()) json["name"] = light.name;
    switch (light.type) {
        case LightType::Point:
            json["position"] = position;
            json["intensity"] = intensity;
            break;
        case LightType::Spot:
            json["type"] = "spot";
            json["position"] = position;
            json["direction"] = vectorJson(glm::dvec3(light.direction));
            json["cutoff_deg"] = glm::degrees(std::acos(std::clamp(double{light.cosCutoff}, -1.0, 1.0)));
            json["beam_deg"] = glm::degrees(std::acos(std::clamp(double{light.cosBeam}, -1.0, 1.0)));
            json["intensity"] = intensity;
            break;
        case LightType::Directional:
            json["type"] = "directional";
            json["direction"] = vectorJson(glm::dvec3(light.direction));
            json["irradiance"] = vectorJson(glm::dvec3(light.emission));
            break;
        case LightType::Constant:
            json["type"] = "constant";
            json["radiance"] = vectorJson(glm::dvec3(light.emission));
            break;
    }
    const bool hasRange = light.type == LightType::Point || light.type == LightType::Spot;
    if (hasRange && std::isfinite(light.range)) json["range"] = unit * double{light.range};
    return json;
}

Json sidecarOf(const ViewToSave& view, const fs::path& target) {
    const fs::path folder = fs::absolute(target).parent_path();
    const fs::path& source = view.scene.path;
    Json json = Json::object();
    if (sceneFileKind(source) == SceneFileKind::Sidecar) {
        json = parseJson(readTextFile(source), source.string());
        json["scene"] = relativeTo(source.parent_path() / json.value("scene", ""), folder).generic_string();
    } else {
        json["scene"] = relativeTo(source, folder).generic_string();
    }
    if (view.pose) json["camera"] = toJson(*view.pose, view.resolution);
    const Json listed = listedLights(json, source.parent_path(), folder);
    if (json.contains("lights")) json["lights"] = listed;
    if (view.lightsChanged) {
        json["lights"] = changedLights(view.scene, listed);
        json["use_gltf_lights"] = false;
    }
    setOrErase(json, "emission", emissionJson(view.scene));
    if (view.moment) json["at"] = *view.moment;
    Json settings = Json::object();
    const Json all = toJson(view.settings);
    for (const auto& [option, value] : all.items())
        if (!value.is_null() && option != "size") settings[option] = value;
    if (view.pose)
        settings.erase("camera");  // the sidecar has one camera, which knows the size
    else
        settings["size"] = fmt::format("{}x{}", view.resolution.x, view.resolution.y);
    if (view.settings.temporal) settings.erase("temporal");  // the viewer has it by itself; others would pay for nothing
    json["settings"] = settings;
    return json;
}

}  // namespace manylight
