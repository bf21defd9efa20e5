// The one way from a scene to pictures: every program goes through here.
#pragma once

#include "engine/graph/execute.h"
#include "engine/image/image.h"
#include "engine/passes/frame_status.h"
#include "engine/techniques/accumulator.h"
#include "engine/techniques/frame_inputs.h"
#include "engine/techniques/gather_tuner.h"
#include "engine/techniques/settings.h"
#include "engine/techniques/temporal_history.h"
#include "shaders/shared/frame.h"

#include <memory>
#include <string>

namespace manylight {

/// Seconds of the one-off work, for the run report.
struct StartupTimes {
    double bvhBuild = 0.0;
    double upload = 0.0;
};

class Renderer {
  public:
    /// Plans, builds the BVH and uploads. `settings` are resolved against the scene: see settings(). Renderers that are
    /// given the same `pipelines` share what is compiled; without, it is the renderer's own. Throws Error.
    Renderer(gpu::Device& device, const Scene& scene, const RenderSettings& settings,
             gpu::PipelineLibrary* pipelines = nullptr);
    ~Renderer();

    /// Renders one more frame, with new light paths and a new sample of every pixel, and adds it to the sum.
    /// Throws Error if the driver cut a ray off (the picture would be wrong).
    Execution renderFrame();

    /// Forgets the frames so far, but for what --temporal makes of them. Resolves as the constructor does; `materials`,
    /// `plan` and `rays` stay what they were there.
    void restart(const RenderSettings& settings);

    /// Forgets the frames so far and looks from `camera`, until restart() is given another index than before.
    void lookThrough(const Camera& camera);
    /// Forgets the frames so far. `scene` is the constructor's with other lights, or other emission of its materials.
    void relight(const Scene& scene);
    /// With --temporal: what is rendered from now on owes nothing to other views. Lights, settings and scenes that
    /// change see to that themselves.
    void forgetHistory() { temporal_.forget(); }
    /// Keeps the frames so far, and shows them accordingly if there are any.
    void setDisplay(float exposure, ToneCurve curve);
    /// After instances, lights or cameras of the scene have moved, as AnimatedScene::moveTo() does. Restarts, as
    /// restart() does. Areas and albedos count as what they were.
    void sceneMoved(const RenderSettings& settings);
    /// After the scene, at its old address, has become another with the same cameras: builds and uploads it anew, with
    /// the pipelines that there are. Restarts. Throws Error as the constructor does, and is of no use after that.
    void sceneReplaced(const RenderSettings& settings);

    /// Mean radiance over the frames so far, RGB, linear Rec. 709, in the scene's own units; with --temporal, as long
    /// as there are few, together with light of earlier views.
    Image radiance();
    /// The picture as displayed: exposure, tone curve; RGB bytes as sRGB-encoded values / 255, row 0 at the top.
    std::vector<uint8_t> displayRgba();
    /// The same on the device, RGBA8_UNORM, for who presents it: valid until the next restart().
    PhysicalImage& display();
    /// From the next frame on, each makes its displayed picture; otherwise the two above make it when they are called.
    void keepDisplay();
    /// From the next frame on, keeps a copy of the VPL list that vpls() reads.
    void keepVpls() { keepsVpls_ = true; }
    /// Restarts with, or without, a record of how far frames scatter: see varianceOfMean().
    void keepVariance(bool keeps);
    bool keepsVariance() const { return radiance_.keepsVariance(); }
    /// Variance of radiance(), per pixel and channel, estimated from its frames as if they were independent. Stratified
    /// frames do better than that. At least 2 frames.
    Image varianceOfMean();
    /// Root mean square of the standard errors of all pixels and channels, over the mean of the picture.
    double relativeStandardError();
    /// Restarts with, or without, cutOff(). Deferred technique only.
    void keepCutOff(bool keeps);
    /// Mean radiance that the bound on the geometry term took, like radiance(). With --clamp bound it is what the
    /// picture lacks.
    Image cutOff();
    /// The VPLs of the last frame, without the padding.
    std::vector<shared::LightData> vpls() const;

    /// As resolved, to be changed and given to restart(); `gbuffer` stays as it was asked for.
    const RenderSettings& settings() const { return settings_; }
    bool gbufferByRays() const { return gbufferByRays_; }
    const Camera& camera() const { return camera_; }
    const ScenePlan& plan() const { return plan_; }
    const GpuScene& gpuScene() const { return gpuScene_; }
    const Warnings& warnings() const { return warnings_; }
    uint32_t frameCount() const { return frameCount_; }
    const shared::FrameStatus& status() const { return status_; }
    /// Area that light reaches, in the normalised frame; known with a bound on the geometry term only. See litArea().
    std::optional<double> litArea() const { return litArea_; }
    const StartupTimes& startupTimes() const { return startupTimes_; }
    GraphExecutor& executor() { return executor_; }
    gpu::PipelineLibrary& pipelines() { return pipelines_; }

    /// What suits the device, as gpu::tuningOf() found it or as it is set for frames to come: no picture changes.
    const gpu::Tuning& tuning() const { return executor_.tuning(); }
    void setTuning(const gpu::Tuning& tuning) { executor_.setTuning(tuning); }

    /// The next frame's graph as Graphviz text, as JSON and as plain text.
    struct GraphDump {
        std::string dot;
        Json json;
        std::string text;
    };
    GraphDump dumpGraph();

  private:
    void resolve(const RenderSettings& settings);
    void measureLitArea();
    void planAgain();
    void makeTargets();
    void makeDisplayTarget();
    void makeDisplay();
    ViewAxes view() const;
    bool isTemporal() const { return settings_.temporal && settings_.show == Show::Picture; }
    uint32_t numberInSequence() const;
    uint32_t pointCount() const;
    glm::vec2 offsetOfPoint(uint32_t point, uint32_t number, uint32_t seed) const;
    void writeFrameConstants();
    void writeConstantsOfPoints(const shared::FrameConstants& first);
    std::vector<SeenPoint> seenPoints(FrameGraph& graph, const SceneHandles& scene);
    void chooseGBuffer();
    FrameGraph declareFrame();
    ImageHandle declareDisplay(FrameGraph& graph, const SceneHandles& scene, ImageHandle sum, uint32_t frameCount);
    void refuseNonFinite(const Execution& execution) const;
    void tuneGather(const Execution& execution);

    gpu::Device& device_;
    const Scene& givenScene_;
    std::optional<Scene> reducedScene_;  // with --materials diffuse
    const Scene& scene_;
    RenderSettings settings_;
    Camera camera_;  // that of the settings, or another that was given
    bool isCameraGiven_ = false;
    ScenePlan plan_;
    StartupTimes startupTimes_;
    GpuScene gpuScene_;
    std::unique_ptr<gpu::PipelineLibrary> ownPipelines_;  // none where they are shared
    gpu::PipelineLibrary& pipelines_;
    GraphExecutor executor_;
    PhysicalBuffer frameConstants_;
    std::vector<PhysicalBuffer> constantsOfPoints_;  // of pixels, but the first
    std::vector<glm::vec2> pixelOffsets_;            // of all points of this frame
    PhysicalBuffer statusBuffer_;
    PhysicalBuffer vplCopy_;
    Accumulator radiance_;
    Accumulator cutOff_;  // exists only if asked for
    TemporalHistory temporal_;
    PhysicalImage display_;
    shared::FrameStatus status_{};
    Warnings warnings_;
    std::optional<double> litArea_;  // see litArea(); with a bound on the geometry term only
    uint32_t frameCount_ = 0;
    bool isUnlimited_ = false;  // the depth limit is ours, not the user's
    bool keepsVpls_ = false;
    bool keepsVariance_ = false;
    bool keepsCutOff_ = false;
    bool gbufferByRays_ = false;
    bool keepsDisplay_ = false;
    GatherTuner gatherTuner_;
};

}  // namespace manylight
