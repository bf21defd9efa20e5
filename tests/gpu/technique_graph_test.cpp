// Each technique's passes and barriers, as reviewed text.
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"
#include "tests/unit/graph_snapshot.h"

namespace manylight::test {
namespace {

/// 300 VPLs with shadows take two stretches.
std::string graphOf(Technique technique) {
    const Scene scene = cornellBox();
    RenderSettings settings = plainSettings(64, 48);
    settings.technique = technique;
    settings.castShadows = true;
    settings.vplCount = 300;
    settings.bounceCount = 4;
    Renderer renderer(device(), scene, settings);
    return renderer.dumpGraph().text;
}

using TechniqueGraph = GpuTest;

TEST_F(TechniqueGraph, Deferred) { expectSnapshot("technique_deferred", graphOf(Technique::Deferred)); }
TEST_F(TechniqueGraph, Forward) { expectSnapshot("technique_forward", graphOf(Technique::Forward)); }
TEST_F(TechniqueGraph, ForwardPrepass) {
    expectSnapshot("technique_forward_prepass", graphOf(Technique::ForwardPrepass));
}

}  // namespace
}  // namespace manylight::test
