#include "apps/view/panels.h"

#include "apps/view_model/sidecar_writer.h"
#include "engine/math/projection.h"
#include "engine/scene/emission_scale.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace manylight {
namespace {

constexpr float kHandle = 7.0f;  // times panelScale()

const char* typeName(LightType type) {
    constexpr std::array kNames = {"point", "spot", "directional", "constant"};
    return kNames[static_cast<size_t>(type)];
}

bool hasPosition(const Light& light) { return light.type == LightType::Point || light.type == LightType::Spot; }
bool hasDirection(const Light& light) { return light.type == LightType::Directional || light.type == LightType::Spot; }

void editVector(const char* what, size_t index, const glm::dvec3& value, double speed, PanelAnswer& answer) {
    std::array<double, 3> numbers = {value.x, value.y, value.z};
    if (ImGui::DragScalarN(fmt::format("{}##{}{}", what, what, index).c_str(), ImGuiDataType_Double, numbers.data(), 3,
                           static_cast<float>(speed), nullptr, nullptr, "%.3g")) {
        answer.commands.push_back(
            fmt::format("light {} {} {:.9g} {:.9g} {:.9g}", index, what, numbers[0], numbers[1], numbers[2]));
        answer.isDragging = true;
    }
}

void drawLight(const Light& light, size_t index, const SceneFrame& frame, PanelAnswer& answer) {
    const double unit = std::ldexp(1.0, frame.exponent);
    const std::string title = fmt::format("{} {} ({})##light{}", index, light.name, typeName(light.type), index);
    if (!ImGui::TreeNode(title.c_str())) return;
    if (hasPosition(light))
        editVector("position", index, frame.center + unit * glm::dvec3(light.position), 0.005 * unit, answer);
    if (hasDirection(light)) editVector("direction", index, glm::dvec3(light.direction), 0.01, answer);
    const auto scaled = [&](const char* label, double factor) {
        ImGui::SameLine();
        if (ImGui::SmallButton(fmt::format("{}##{}{}", label, label, index).c_str()))
            answer.commands.push_back(fmt::format("light {} brightness {}", index, factor));
    };
    ImGui::TextUnformatted("brightness");
    scaled("/2", 0.5);
    scaled("-10 %", 0.9);
    scaled("+10 %", 1.1);
    scaled("x2", 2.0);
    ImGui::SameLine();
    if (ImGui::SmallButton(fmt::format("remove##remove{}", index).c_str()))
        answer.commands.push_back(fmt::format("light {} remove", index));
    ImGui::TreePop();
}

/// Materials that shine, each with a factor on what its file says.
void drawSurfaceEmitters(const PanelView& view, PanelAnswer& answer) {
    const std::vector<SurfaceEmitter> emitters = surfaceEmitters(*view.state.scene);
    const EmitterTable& table = view.main.renderer().gpuScene().emitterTable;
    ImGui::Text("%zu emissive materials, %u area lights", emitters.size(), table.areaLightCount);
    for (size_t i = 0; i < emitters.size(); ++i) {
        const glm::vec3 radiance = emitters[i].givenRadiance;
        const glm::vec3 hue = radiance / std::max({radiance.x, radiance.y, radiance.z});
        ImGui::ColorButton(fmt::format("##emission colour{}", i).c_str(), {hue.x, hue.y, hue.z, 1.0f},
                           ImGuiColorEditFlags_NoTooltip, {ImGui::GetFontSize(), ImGui::GetFontSize()});
        ImGui::SameLine();
        float scale = emitters[i].scale;
        const std::string label = fmt::format("{}##emission{}", emitters[i].material, i);
        if (ImGui::SliderFloat(label.c_str(), &scale, 0.0f, 10.0f, "x %.3g", ImGuiSliderFlags_Logarithmic)) {
            answer.commands.push_back(fmt::format("emission {} {:.9g}", i, std::max(scale, 0.0f)));
            answer.isDragging = true;
        }
    }
}

/// Where a point is seen, in the window's units; empty behind the camera.
std::optional<ImVec2> seenAt(const Camera& camera, const glm::vec3& point) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const ViewAxes view = viewAxes(camera.origin, camera.forward, camera.up, camera.verticalFov, window.x / window.y);
    const glm::vec4 clip = clipFromWorld(view, 1e-4f, glm::vec2(0.0f)) * glm::vec4(point, 1.0f);
    if (clip.w <= 0.0f) return std::nullopt;
    return ImVec2((0.5f + 0.5f * clip.x / clip.w) * window.x, (0.5f + 0.5f * clip.y / clip.w) * window.y);
}

/// The point as far from the camera as `light`, where the mouse has moved to.
glm::vec3 dragged(const Camera& camera, const glm::vec3& light, const ImVec2& delta) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const ViewAxes view = viewAxes(camera.origin, camera.forward, camera.up, camera.verticalFov, window.x / window.y);
    const float depth = glm::dot(light - camera.origin, camera.forward);
    return light + depth * (2.0f * delta.x / window.x * view.right + 2.0f * delta.y / window.y * view.down);
}

}  // namespace

void drawLights(const PanelView& view, PanelAnswer& answer) {
    const Scene& scene = *view.state.scene;
    for (size_t i = 0; i < scene.lights.size(); ++i) drawLight(scene.lights[i], i, scene.frame, answer);
    drawSurfaceEmitters(view, answer);
    for (const char* type : {"point", "spot", "directional"}) {
        if (ImGui::SmallButton(fmt::format("add {}", type).c_str()))
            answer.commands.push_back(fmt::format("add-light {}", type));
        ImGui::SameLine();
    }
    ImGui::NewLine();
    if (view.state.lightHistory.steps() > 0 && ImGui::SmallButton("undo")) answer.commands.emplace_back("undo");
}

void drawLightHandles(const PanelView& view, PanelAnswer& answer) {
    std::optional<size_t>& held = view.heldLight;
    const Scene& scene = *view.state.scene;
    const Camera& camera = view.main.renderer().camera();
    const ImGuiIO& io = ImGui::GetIO();
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left) || (held && *held >= scene.lights.size())) held.reset();
    for (size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const auto place = hasPosition(light) ? seenAt(camera, light.position) : std::nullopt;
        if (!place) continue;
        const float radius = kHandle * panelScale();
        const bool isNear = std::hypot(io.MousePos.x - place->x, io.MousePos.y - place->y) <= radius;
        if (isNear && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !io.WantCaptureMouse) held = i;
        ImGui::GetBackgroundDrawList()->AddCircle(
            *place, radius, isNear || held == i ? IM_COL32(255, 220, 80, 255) : IM_COL32(255, 255, 255, 140), 16, 2.0f);
    }
    if (!held) return;
    if (io.MouseDelta.x == 0.0f && io.MouseDelta.y == 0.0f) return;
    const glm::dvec3 position =
        scene.frame.center + std::ldexp(1.0, scene.frame.exponent) *
                                 glm::dvec3(dragged(camera, scene.lights[*held].position, io.MouseDelta));
    answer.commands.push_back(
        fmt::format("light {} position {:.9g} {:.9g} {:.9g}", *held, position.x, position.y, position.z));
    answer.isDragging = true;
}

}  // namespace manylight
