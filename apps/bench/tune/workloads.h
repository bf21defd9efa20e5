// The frames that a tuning is measured on.
#pragma once

#include "apps/bench/tune/options.h"
#include "engine/gpu/tuning.h"
#include "engine/techniques/renderer.h"

#include <memory>

namespace manylight {

/// A way to shade with the kernels that some tunables are about.
enum class Way : uint8_t {
    Gather,   // from every VPL, without rays
    Shadows,  // from fewer, with a ray for each
    Draft,    // from a subset, with few rays and a filter
    Paths,    // the path tracer
};

/// What of a frame a tunable changes: the time of passes whose names begin so, in these ways to shade.
struct Reach {
    std::vector<Way> ways;
    std::vector<std::string> passes;
};
/// Of the tunable of that name.
Reach reachOf(const std::string& tunable);

struct Workload {
    Way way = Way::Gather;
    std::unique_ptr<Renderer> renderer;
    RenderSettings settings;  // resolved
};
using Workloads = std::vector<Workload>;

bool isAskedFor(const TuneOptions& options, const gpu::Tunable& tunable);

/// Of every scene the ways that the tunables are about which are asked for. The scenes must outlive it.
Workloads makeWorkloads(gpu::Device& device, const std::vector<Scene>& scenes, const TuneOptions& options);

/// The same frame for every tuning.
Execution renderWith(Workload& workload, const gpu::Tuning& tuning);
/// Milliseconds of the passes that `reach` names.
double milliseconds(const Execution& execution, const Reach& reach);

}  // namespace manylight
