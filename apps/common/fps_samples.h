// Frame times of combinations of method, shadows and VPL count: what tables of FPS are made from.
#pragma once

#include "engine/techniques/renderer.h"

#include <array>

namespace manylight {

inline constexpr double kSlowFrame = 2000.0;  // milliseconds; such frames are warmed up once only
/// VPLs with shadows that a software driver is asked for unless told: a shadow ray costs it 100 times an unshadowed
/// pair.
inline constexpr uint32_t kMaxShadowedOnSoftware = 90;

/// What is compared. Interleaved: deferred shading, each of 4 x 4 neighbours with its own sixteenth of the VPLs, which
/// shows as a pattern until frames average it away. Filtered: the same put together again by --filter atrous.
enum class FpsMethod : uint8_t { Forward, ForwardPrepass, Deferred, Interleaved, Filtered };

inline constexpr std::array kFpsMethods = {FpsMethod::Forward, FpsMethod::ForwardPrepass, FpsMethod::Deferred,
                                           FpsMethod::Interleaved, FpsMethod::Filtered};

/// As --techniques of `manylight-bench fps` calls it; of the first three the technique's own name.
const char* name(FpsMethod method);

/// One combination that is measured.
struct FpsCell {
    FpsMethod method = FpsMethod::Deferred;
    bool castShadows = false;
    uint32_t vplCount = 0;
};

/// Milliseconds of one pass, or of the passes that share its name, in every frame.
struct PassSamples {
    std::string pass;
    std::vector<double> milliseconds;
};

/// Samples of one cell, one a frame, over all rounds; milliseconds.
struct FpsSamples {
    FpsCell cell;
    std::vector<double> wall;         // submit to fence
    std::vector<double> host;         // the rest of Renderer::renderFrame(): declaring, compiling, recording
    std::vector<double> gpu;          // first timestamp to last
    std::vector<PassSamples> passes;  // in the order they ran
    std::vector<double> vplsShaded;
};

/// Restarts with the cell's method, shadows and VPL count, and all else as in `settings`.
void restartFor(Renderer& renderer, RenderSettings settings, const FpsCell& cell);

/// Renders a frame, adds it to `samples` unless that is null, and returns its milliseconds, submit to fence.
double measureFrame(Renderer& renderer, FpsSamples* samples);

}  // namespace manylight
