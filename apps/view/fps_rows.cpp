#include "apps/view/fps_rows.h"

#include "engine/core/statistics.h"

#include <algorithm>

namespace manylight {
namespace {

constexpr uint32_t kRounds = 2;  // turns of each combination, to share the machine's drift
constexpr uint32_t kFramesPerTurn = 3;
constexpr uint32_t kFirstWarmUps = 3;  // frames in which pipelines are compiled
constexpr uint32_t kLaterWarmUps = 1;

/// What forward shading has, too, and a picture of light.
RenderSettings comparable(RenderSettings settings) {
    settings.show = Show::Picture;
    settings.interleave = 1;
    settings.gatherStep = 1;
    settings.shadowRays = 0;
    settings.gbuffer = GBufferBy::Auto;
    settings.jitter = false;
    if (settings.lighting == Lighting::Local) settings.lighting = Lighting::Both;
    settings.pathCount = 0;
    return settings;
}

}  // namespace

void FpsRows::start(const RenderSettings& settings, std::vector<uint32_t> vplCounts, bool isSoftwareDevice) {
    settings_ = comparable(settings);
    if (vplCounts.empty()) {
        vplCounts = {20, 50, kMaxShadowedOnSoftware};
        if (!settings_.castShadows || !isSoftwareDevice) vplCounts.push_back(200);
    }
    std::sort(vplCounts.begin(), vplCounts.end());
    cells_.clear();
    for (const uint32_t vplCount : vplCounts)
        for (const FpsMethod method : {FpsMethod::Forward, FpsMethod::ForwardPrepass, FpsMethod::Deferred}) {
            FpsSamples samples;
            samples.cell = {method, settings_.castShadows, vplCount};
            cells_.push_back(std::move(samples));
        }
    turns_ = kRounds * cells_.size();
    nextTurn_ = 0;
    isFresh_ = true;
}

void FpsRows::step(Renderer& renderer) {
    FpsSamples& samples = cells_[nextTurn_ % cells_.size()];
    if (isFresh_) {
        restartFor(renderer, settings_, samples.cell);
        const bool isSlow = !samples.wall.empty() && median(samples.wall) > kSlowFrame;
        warmUpsLeft_ = isSlow ? 0 : samples.wall.empty() ? kFirstWarmUps : kLaterWarmUps;
        framesLeft_ = kFramesPerTurn;
        isFresh_ = false;
    }
    if (warmUpsLeft_ > 0) {
        --warmUpsLeft_;
        if (measureFrame(renderer, nullptr) > kSlowFrame) warmUpsLeft_ = 0;
        return;
    }
    measureFrame(renderer, &samples);
    if (--framesLeft_ > 0) return;
    ++nextTurn_;
    isFresh_ = true;
}

Json toJson(const FpsRows& rows) {
    Json list = Json::array();
    for (const FpsSamples& samples : rows.cells()) {
        if (samples.wall.empty()) continue;
        const double milliseconds = median(samples.wall);
        list.push_back({{"technique", name(samples.cell.method)},
                        {"shadows", samples.cell.castShadows},
                        {"vpls", samples.cell.vplCount},
                        {"frames", samples.wall.size()},
                        {"milliseconds", milliseconds},
                        {"fps", 1000.0 / milliseconds}});
    }
    return list;
}

}  // namespace manylight
