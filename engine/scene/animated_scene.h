// A scene file whose animation is played.
#pragma once

#include "engine/scene/import.h"
#include "engine/scene/raw_scene.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace manylight {

/// Seconds of the animation of a scene file, 0 if nothing moves; meshes are not read. The file is kept open where
/// `options` say, so that AnimatedScene or importScene() need not read it again. Throws Error as importScene() does.
double animationEndOf(const std::filesystem::path& path, ImportOptions options);

/// Moments from the start to the end at which a frame of the scene looks for what moves.
std::vector<double> samplesOfMotion(double end);

class AnimatedScene {
  public:
    /// Reads the scene at the first of `times` (seconds, at least one), in a frame that holds what moves at all of
    /// them, and then moves to `time`, if one is given. Throws Error as importScene() does.
    AnimatedScene(std::filesystem::path path, const ImportOptions& options, std::vector<double> times,
                  std::optional<double> time = std::nullopt);

    const Scene& scene() const { return scene_; }
    Scene release() { return std::move(scene_); }
    /// For who changes its lights; moveTo() puts back those that the file has.
    Scene& scene() { return scene_; }

    enum class Change : uint8_t {
        Places,      // of instances, lights and cameras: Renderer::sceneMoved() shows them
        Everything,  // a mesh was deformed, vanished, appeared or was turned inside out: Renderer::sceneReplaced()
    };
    Change moveTo(double time);

  private:
    RawScene placesAt(double time) const;
    void read(double time);
    std::vector<glm::dvec3> framePointsFor(const RawScene& raw) const;

    std::filesystem::path path_;
    ImportOptions options_;
    std::vector<double> times_;
    mutable std::shared_ptr<const GltfFile> opened_;
    Scene scene_;
    std::vector<glm::dvec3>
        framePoints_;  // the bounds hold all of the motion: the camera and lights of all pictures agree
    std::vector<uint32_t> meshOfSource_;  // of the instances in the file
    std::vector<double> shape_;           // RawScene::shape of what is there
};

}  // namespace manylight
