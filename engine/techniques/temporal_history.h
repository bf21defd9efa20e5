// What is shown of a view, and what it leaves to the next one.
#pragma once

#include "engine/image/image.h"
#include "engine/math/projection.h"
#include "engine/passes/temporal.h"

#include <optional>

namespace manylight {

class TemporalHistory {
  public:
    /// Makes images of that size. What a picture of another size left is kept until a frame has taken it over.
    void makeRoom(gpu::Device& device, uint32_t width, uint32_t height);
    /// The next view begins without a history.
    void forget();
    /// Objects or lights have moved: the next view takes over what does not differ from the pixels around.
    void sceneMoved() { sceneMoved_ = true; }

    /// Frames since forget(), if those before the first one of `view` show something else; 0 otherwise. Light of
    /// earlier views helps only frames that draw other light paths.
    uint32_t framesBefore(const ViewAxes& view) const;

    /// Declares what follows when `radiance` has been added to `sum`, after `frameCount` frames. Returns the sum as it
    /// is to be shown.
    ImageHandle add(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                    ImageHandle radiance, ImageHandle sum, uint32_t frameCount);
    /// The frame that add() declared has run, from `view`.
    void finishFrame(const ViewAxes& view, uint32_t frameCount);

    /// The sum as it was shown last, to be read.
    ImageHandle shown(FrameGraph& graph) { return importPhysical(graph, kShown, now_.shown); }
    /// RGB of the same, over `frameCount`.
    Image mean(gpu::Device& device, uint32_t frameCount);

  private:
    static constexpr const char* kShown = "shown sum";

    struct Images {
        PhysicalImage shown;
        PhysicalImage guide;
    };
    shared::ReprojectionPush reprojection(const Images& before) const;

    Images now_;
    std::optional<Images> earlier_;  // of another size
    PhysicalImage reprojected_;      // what the frames of this view found in earlier ones
    ViewAxes view_;                  // of the last frame
    uint32_t framesOfView_ = 0;
    uint32_t frames_ = 0;  // since forget()
    bool isReprojected_ = false;
    bool sceneMoved_ = false;
};

}  // namespace manylight
