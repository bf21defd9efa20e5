// The converged picture that errors are measured against, with its own error.
#pragma once

#include "apps/bench/error_options.h"
#include "engine/image/image.h"
#include "engine/techniques/renderer.h"

#include <array>
#include <optional>

namespace manylight {

struct Reference {
    Image image;
    /// The two halves that it is the mean of, if it was made here: half of the RMSE between them is its own.
    std::optional<std::array<Image, 2>> halves;
    uint64_t samplesPerPixel = 0;  // 0: not known
    double seconds = 0.0;          // spent on it now
    std::filesystem::path file;    // where it is kept, or came from
};

/// Path traced in two halves by independent seeds, in rounds that double the samples, until its error is small enough
/// or the time is used up. Kept in the cache folder under the scene's key after every round; a later call goes on from
/// there. `settings` are resolved. Restarts `renderer`. With options.referenceFile, reads that instead.
Reference makeReference(Renderer& renderer, const Scene& scene, const RenderSettings& settings,
                        const ErrorOptions& options);

}  // namespace manylight
