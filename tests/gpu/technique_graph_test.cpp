// Each technique's passes and barriers, as reviewed text.
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"
#include "tests/unit/graph_snapshot.h"

namespace manylight::test {
namespace {

/// 300 VPLs with shadows take two stretches.
std::string graphOf(Technique technique, ClampMode clamp = ClampMode::Off, int bounces = 4, uint32_t interleave = 1) {
    const Scene scene = cornellBox();
    RenderSettings settings = plainSettings(64, 48);
    settings.technique = technique;
    settings.castShadows = true;
    settings.vplCount = 300;
    settings.bounceCount = bounces;
    settings.clamp = clamp;
    settings.interleave = interleave;
    settings.filter = interleave > 1 ? Filter::Atrous : Filter::Off;
    settings.visibilitySamples = 2;  // with a filter
    Renderer renderer(device(), scene, settings, pipelines());
    renderer.keepDisplay();
    return renderer.dumpGraph().text;
}

using TechniqueGraph = GpuTest;

TEST_F(TechniqueGraph, Deferred) { expectSnapshot("technique_deferred", graphOf(Technique::Deferred)); }
TEST_F(TechniqueGraph, DeferredAndFiltered) {
    expectSnapshot("technique_deferred_filtered", graphOf(Technique::Deferred, ClampMode::Off, 4, 4));
}
// The second view, which looks back at the first.
TEST_F(TechniqueGraph, DeferredAndTemporal) {
    const Scene scene = cornellBox();
    RenderSettings settings = plainSettings(64, 48);
    settings.vplCount = 16;
    settings.temporal = true;
    Renderer renderer(device(), scene, settings, pipelines());
    renderer.keepDisplay();
    renderer.renderFrame();
    Camera camera = scene.cameras.front();
    camera.origin.x += 0.01f;
    renderer.lookThrough(camera);
    expectSnapshot("technique_deferred_temporal", renderer.dumpGraph().text);
}
TEST_F(TechniqueGraph, Forward) { expectSnapshot("technique_forward", graphOf(Technique::Forward)); }
TEST_F(TechniqueGraph, ForwardPrepass) {
    expectSnapshot("technique_forward_prepass", graphOf(Technique::ForwardPrepass));
}
TEST_F(TechniqueGraph, DeferredAndCompensated) {
    expectSnapshot("technique_deferred_compensated", graphOf(Technique::Deferred, ClampMode::Compensate));
}
TEST_F(TechniqueGraph, ForwardAndCompensated) {
    expectSnapshot("technique_forward_compensated", graphOf(Technique::Forward, ClampMode::Compensate));
}
TEST_F(TechniqueGraph, PathTracer) { expectSnapshot("technique_path_tracer", graphOf(Technique::PathTracer)); }
TEST_F(TechniqueGraph, PathTracerOfLongPaths) {
    expectSnapshot("technique_path_tracer_long", graphOf(Technique::PathTracer, ClampMode::Off, 100));
}

}  // namespace
}  // namespace manylight::test
