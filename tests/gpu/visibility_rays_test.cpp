// What a pixel sees, by rays: the same triangles as by the rasteriser, but for pixels at edges.
#include "engine/techniques/gbuffer_capture.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/instanced_scenes.h"

namespace manylight::test {
namespace {

class VisibilityRays : public GpuTest {};

GBufferImage gbufferBy(GBufferBy by, const Scene& scene) {
    RenderSettings settings = plainSettings(64, 48);
    settings.gbuffer = by;
    Renderer renderer(device(), scene, settings, pipelines());
    return captureGBuffer(renderer, scene);
}

/// The rasteriser rounds corners to 1/256 pixel: pixels that an edge comes so close to may see either side.
void expectSameSurfaces(const Scene& scene) {
    const GBufferImage raster = gbufferBy(GBufferBy::Raster, scene);
    const GBufferImage rays = gbufferBy(GBufferBy::Rays, scene);
    size_t seen = 0;
    size_t others = 0;
    for (size_t i = 0; i < raster.texels.size(); ++i) {
        const GBufferTexel& a = raster.texels[i];
        const GBufferTexel& b = rays.texels[i];
        seen += a.isSurface ? 1 : 0;
        if (a.isSurface != b.isSurface || a.triangle != b.triangle) {
            ++others;
            continue;
        }
        EXPECT_EQ(a.position, b.position) << "pixel " << i;
        EXPECT_EQ(a.normal, b.normal) << "pixel " << i;
        EXPECT_EQ(a.albedo, b.albedo) << "pixel " << i;
    }
    EXPECT_GT(seen, raster.texels.size() / 2);
    EXPECT_LE(others, raster.texels.size() / 100);
}

TEST_F(VisibilityRays, SeeWhatTheRasteriserSees) { expectSameSurfaces(cornellBox()); }

TEST_F(VisibilityRays, SeeThroughHolesAndBacksOfInstances) { expectSameSurfaces(roomOfInstances()); }

TEST_F(VisibilityRays, AreTakenWhereTrianglesOutnumberPixels) {
    const Scene scene = cornellBox();
    const auto chosen = [&](uint32_t width, uint32_t height) {
        RenderSettings settings = plainSettings(width, height);
        settings.gbuffer = GBufferBy::Auto;
        return Renderer(device(), scene, settings, pipelines()).gbufferByRays();
    };
    EXPECT_FALSE(chosen(64, 48));
    EXPECT_TRUE(chosen(2, 2));
}

TEST_F(VisibilityRays, ThatWereChosenAreNotAskedOfOtherTechniques) {
    const Scene scene = cornellBox();
    RenderSettings settings = plainSettings(2, 2);
    settings.gbuffer = GBufferBy::Auto;
    settings.castShadows = true;
    Renderer renderer(device(), scene, settings, pipelines());
    ASSERT_TRUE(renderer.gbufferByRays());
    settings = renderer.settings();
    settings.technique = Technique::PathTracer;
    EXPECT_NO_THROW(renderer.restart(settings));
    EXPECT_FALSE(renderer.gbufferByRays());
}

TEST_F(VisibilityRays, AreRefusedWhereDepthIsNeeded) {
    RenderSettings settings = plainSettings(8, 8);
    settings.gbuffer = GBufferBy::Rays;
    settings.show = Show::Vpls;
    EXPECT_THROW(Renderer(device(), cornellBox(), settings, pipelines()), Error);
    settings.show = Show::Picture;
    settings.technique = Technique::Forward;
    EXPECT_THROW(Renderer(device(), cornellBox(), settings, pipelines()), Error);
}

}  // namespace
}  // namespace manylight::test
