#include "engine/techniques/plan_rays.h"

#include "engine/core/error.h"

#include <fmt/format.h>

namespace manylight {

RayAbilities rayAbilities(const gpu::Device& device) {
    return {device.info().name, device.missingForRays(), device.info().isSoftware()};
}

void planRays(ScenePlan& plan, RaysBy asked, const RayAbilities& abilities) {
    const bool canTrace = abilities.missing.empty();
    if (asked == RaysBy::Hardware && !canTrace)
        fail("--rays hardware: device {} lacks {}", abilities.device, abilities.missing);
    plan.hardwareRays = asked == RaysBy::Hardware || (asked == RaysBy::Auto && canTrace && !abilities.isSoftware);
    const std::string reason = asked != RaysBy::Auto ? fmt::format("--rays {}", name(asked))
                               : !canTrace           ? fmt::format("the device lacks {}", abilities.missing)
                               : abilities.isSoftware
                                   ? "the device is a CPU, which is faster at the shaders' own traversal"
                                   : "the device traces them, without BVH nodes";
    plan.decisions.push_back(
        {.what = kPlanHardwareRays, .leftOut = !plan.hardwareRays, .reason = reason, .canBeKept = false});
}

}  // namespace manylight
