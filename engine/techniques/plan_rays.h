// Who traces rays: shaders, or the device.
#pragma once

#include "engine/gpu/device.h"
#include "engine/scene/scene_plan.h"
#include "engine/techniques/settings.h"

#include <string>

namespace manylight {

/// What matters about a device for that.
struct RayAbilities {
    std::string device;   // its name
    std::string missing;  // what it lacks for tracing rays itself; empty: nothing
    bool isSoftware = false;
};
RayAbilities rayAbilities(const gpu::Device& device);

inline constexpr const char* kPlanHardwareRays = "hardware rays";

/// Adds the decision and its reason to the plan. Throws Error if hardware rays are asked for and the device has none.
void planRays(ScenePlan& plan, RaysBy asked, const RayAbilities& abilities);

}  // namespace manylight
