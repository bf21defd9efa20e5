// Commands that change the scene's lights.
#include "apps/view/viewer.h"

#include "engine/scene/emission_scale.h"

#include <imgui.h>
#include <glm/gtc/constants.hpp>

#include <cmath>

namespace manylight {
namespace {

/// Before the camera, with half of the power that the scene has so far.
Light newLight(const std::string& type, const Camera& camera, double scenePower) {
    Light light;
    light.name = "added";
    light.position = camera.origin + 0.3f * camera.forward;
    light.direction = camera.forward;
    const double power = scenePower > 0.0 ? 0.5 * scenePower : 1.0;
    light.emission = glm::vec3(static_cast<float>(power / (4.0 * glm::pi<double>())));
    if (type == "spot") {
        light.type = LightType::Spot;
        light.cosCutoff = std::cos(glm::radians(30.0f));
        light.cosBeam = std::cos(glm::radians(20.0f));
        light.emission *= 8.0f;
    } else if (type == "directional") {
        light.type = LightType::Directional;
        light.emission = glm::vec3(static_cast<float>(power));
    } else if (type != "point") {
        fail("add-light {}: expected point, spot or directional", type);
    }
    return light;
}

}  // namespace

bool Viewer::performLightCommand(const Command& command) {
    const std::string& name = command.name();
    if (name == "undo") {
        undoLights();
        return true;
    }
    if (name != "add-light" && name != "light" && name != "emission") return false;
    LightState before = lightState();
    std::string subject = name;
    if (name == "add-light") {
        if (!main_.exists()) fail("{}: add-light: there is no picture", command.place);
        const double power = main_.renderer().gpuScene().emitterTable.totalPower;
        state_.scene->lights.push_back(newLight(command.words[1], main_.renderer().camera(), power));
    } else if (name == "light") {
        changeLight(command);
        subject += " " + command.words[1] + " " + command.words[2];
    } else {
        changeEmission(command);
        subject += " " + command.words[1];
    }
    const bool isHeld = command.place == "panel" && ImGui::IsMouseDown(ImGuiMouseButton_Left);
    state_.lightHistory.note(std::move(before), subject, isHeld);
    state_.lightsChanged |= name != "emission";
    relight();
    return true;
}

LightState Viewer::lightState() const {
    LightState state{state_.scene->lights, {}, state_.lightsChanged};
    for (const Material& material : state_.scene->materials) state.emissionScales.push_back(material.emissionScale);
    return state;
}

void Viewer::changeEmission(const Command& command) {
    const std::vector<SurfaceEmitter> emitters = surfaceEmitters(*state_.scene);
    if (emitters.empty()) fail("{}: emission: no surface of this scene shines", command.place);
    const uint32_t index = command.whole(1, 0, static_cast<uint32_t>(emitters.size() - 1));
    const double scale = command.number(2);
    if (!(scale >= 0.0 && scale <= double{kLargestEmissionScale}))
        fail("{}: emission: expected a factor from 0 to {}", command.place, kLargestEmissionScale);
    scaleEmission(*state_.scene, emitters[index].material, static_cast<float>(scale));
}

void Viewer::undoLights() {
    const std::optional<LightState> before = state_.lightHistory.takeBack();
    if (!before) return tell("undo: no light was changed");
    Scene& scene = *state_.scene;
    scene.lights = before->lights;
    for (size_t i = 0; i < scene.materials.size(); ++i) scaleEmission(scene.materials[i], before->emissionScales[i]);
    state_.lightsChanged = before->lightsChanged;
    // Lights of a file that moves are where they are now, not where they were then.
    if (playable_.isAnimated() && !before->lightsChanged) playable_.moveTo(playable_.time(), false);
    relight();
}

void Viewer::changeLight(const Command& command) {
    std::vector<Light>& lights = state_.scene->lights;
    const double number = command.number(1);
    const std::string& what = command.words[2];
    if (!(number >= 0.0 && number < static_cast<double>(lights.size())))
        fail("{}: light {}: there are {}, counted from 0", command.place, command.words[1], lights.size());
    const auto index = static_cast<size_t>(number);
    const auto expect = [&](size_t values) {
        if (command.words.size() != values + 3)
            fail("{}: light {}: expected {} number(s)", command.place, what, values);
    };
    const auto vector = [&] { return glm::dvec3(command.number(3), command.number(4), command.number(5)); };
    if (what == "brightness") {
        expect(1);
        if (!(command.number(3) >= 0.0)) fail("{}: light brightness: expected a factor, 0 or more", command.place);
        lights[index].emission *= static_cast<float>(command.number(3));
    } else if (what == "position") {
        expect(3);
        const SceneFrame& frame = state_.scene->frame;
        lights[index].position = glm::vec3(std::ldexp(1.0, -frame.exponent) * (vector() - frame.center));
    } else if (what == "direction") {
        expect(3);
        if (vector() == glm::dvec3(0.0)) fail("{}: light direction: expected a vector that is not zero", command.place);
        lights[index].direction = glm::vec3(glm::normalize(vector()));
    } else if (what == "remove") {
        expect(0);
        lights.erase(lights.begin() + static_cast<ptrdiff_t>(index));
    } else {
        fail("{}: light: expected brightness, position, direction or remove, found '{}'", command.place, what);
    }
}

void Viewer::relight() {
    stopFps();
    presenter_.finish();
    main_.relight(*state_.scene);
    other_.relight(*state_.scene);
}

}  // namespace manylight
