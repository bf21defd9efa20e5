// Frames until the count, the time or the error that was asked for.
#pragma once

#include "apps/capture/capture.h"
#include "engine/graph/execute.h"
#include "engine/techniques/renderer.h"

namespace manylight {

struct Frames {
    Json passes = Json::object();  // GPU milliseconds by pass, over all frames
    double seconds = 0.0;
    double firstFrameSeconds = 0.0;
    std::optional<double> relativeError;  // if it was asked for
    const char* endedBy = "frames";       // "frames", "time", "error" or "interrupt"
    std::vector<DumpedImage> dumped;
};

/// At least one frame. Ctrl-C ends it after the frame at hand.
Frames renderFrames(Renderer& renderer, const CaptureOptions& options);

}  // namespace manylight
