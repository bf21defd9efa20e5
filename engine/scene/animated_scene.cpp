#include "engine/scene/animated_scene.h"

#include "engine/scene/instances.h"
#include "engine/scene/normalise.h"
#include "engine/scene/normalise_parts.h"
#include "engine/scene/scene_file.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace manylight {
namespace {

constexpr double kSampleRate = 24.0;  // a second
constexpr double kMostSamples = 240.0;

struct RawBox {
    glm::dvec3 low{std::numeric_limits<double>::max()};
    glm::dvec3 high{std::numeric_limits<double>::lowest()};

    void include(const glm::dvec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
};

RawBox boxOf(const RawMesh& mesh) {
    RawBox box;
    for (const RawVertex& vertex : mesh.vertices) box.include(vertex.position);
    return box;
}

std::vector<uint32_t> meshesOf(const std::vector<RawInstance>& instances) {
    std::vector<uint32_t> meshes;
    for (const RawInstance& instance : instances) meshes.push_back(instance.mesh);
    return meshes;
}

}  // namespace

double animationEndOf(const std::filesystem::path& path, ImportOptions options) {
    options.time = 0.0;
    options.placesOnly = true;
    return readSceneFile(path, options).animationEnd;
}

std::vector<double> samplesOfMotion(double end) {
    const double count = std::clamp(std::ceil(end * kSampleRate), 1.0, kMostSamples);
    std::vector<double> times;
    for (double i = 0.0; i <= count; ++i) times.push_back(end * (i / count));
    return times;
}

AnimatedScene::AnimatedScene(std::filesystem::path path, const ImportOptions& options, std::vector<double> times,
                             std::optional<double> time)
    : path_(std::move(path)), options_(options), times_(std::move(times)) {
    if (options.opened != nullptr) opened_ = *options.opened;
    options_.keepsMoving = true;
    options_.opened = &opened_;
    read(times_.front());
    if (time && *time != times_.front()) moveTo(*time);
}

RawScene AnimatedScene::placesAt(double time) const {
    ImportOptions options = options_;
    options.time = time;
    options.placesOnly = true;
    return readSceneFile(path_, options);
}

std::vector<glm::dvec3> AnimatedScene::framePointsFor(const RawScene& raw) const {
    std::vector<RawBox> boxes;
    for (const RawMesh& mesh : raw.meshes) boxes.push_back(boxOf(mesh));
    RawBox all;
    for (const double time : times_) {
        const RawScene places = placesAt(time);
        for (const glm::dvec3& point : places.framePoints) all.include(point);
        if (meshesOf(places.instances) != meshesOf(raw.instances)) continue;
        for (const RawInstance& instance : places.instances)
            for (int corner = 0; corner < 8; ++corner) {
                const RawBox& box = boxes[instance.mesh];
                const glm::dvec3 point(corner & 1 ? box.low.x : box.high.x, corner & 2 ? box.low.y : box.high.y,
                                       corner & 4 ? box.low.z : box.high.z);
                all.include(instance.sceneFromMesh * glm::dvec4(point, 1.0));
            }
    }
    if (!(all.low.x <= all.high.x)) return {};
    return {all.low, all.high};
}

void AnimatedScene::read(double time) {
    ImportOptions options = options_;
    options.time = time;
    RawScene raw = readSceneFile(path_, options);
    std::vector<uint32_t> meshes = meshesOf(raw.instances);
    // What only deforms keeps its frame, or each picture would look at all times again.
    if (framePoints_.empty() || meshes != meshOfSource_) framePoints_ = framePointsFor(raw);
    raw.framePoints = framePoints_;
    meshOfSource_ = std::move(meshes);
    shape_ = raw.shape;
    scene_ = normalise(std::move(raw));
}

AnimatedScene::Change AnimatedScene::moveTo(double time) {
    const RawScene places = placesAt(time);
    const size_t before = scene_.instances.size();
    if (meshesOf(places.instances) != meshOfSource_ || places.shape != shape_) {
        read(time);
        return Change::Everything;
    }
    // Defaults stay: they were chosen for lack of lights and cameras in the file.
    if (!places.cameras.empty()) {
        scene_.cameras.clear();
        convertCameras(places, scene_);
        addMissingCamera(scene_);
    }
    if (!places.lights.empty()) {
        scene_.lights.clear();
        convertLights(places, scene_);
    }
    if (scene_.instances.empty()) return Change::Places;
    placeInstances(places, scene_);
    if (scene_.instances.size() != before) {
        read(time);
        return Change::Everything;
    }
    setBounds(scene_, boundsOfInstances(scene_, listInstances(scene_)));
    includeInBounds(scene_, framePoints_);
    return Change::Places;
}

}  // namespace manylight
