// Pictures, lists and scenes that are small, large or of awkward sizes.
#include "apps/bench/stability/families.h"
#include "apps/bench/stability/lab.h"
#include "apps/bench/stability/scenes.h"

#include <fmt/format.h>

namespace manylight::stability {
namespace {

Scene litRoom(uint32_t cells) {
    RawScene raw = emptyScene();
    addRoom(raw, glm::dvec3(-0.5), glm::dvec3(0.5), addMaterial(raw, {0.7, 0.5, 0.3}), cells);
    addPointLight(raw, {0.1, 0.2, 0.1}, glm::dvec3(1.0));
    addCamera(raw, {0.05, 0.1, 0.35}, {0.0, -0.1, -0.5}, 1.2);
    return normalise(std::move(raw));
}

}  // namespace

Findings pictureSizes(StabilityLab& lab) {
    Findings findings;
    const Scene scene = normalise(furnishedRoom());
    for (const Technique technique : {Technique::Deferred, Technique::Forward, Technique::PathTracer})
        for (const glm::uvec2 size : {glm::uvec2(1, 1), glm::uvec2(1, 8193), glm::uvec2(8193, 1)}) {
            RenderSettings settings = withTechnique(stabilitySettings(size.x, size.y), technique);
            settings.vplCount = 5;
            const Image image = lab.render(scene, settings);
            Finding finding = notBlack(fmt::format("{}x{}, {}", size.x, size.y, name(technique)), image);
            if (image.width != size.x || image.height != size.y) finding.verdict = Verdict::Fails;
            findings.push_back(std::move(finding));
        }
    const uint32_t most = lab.device().limits().maxImageDimension2D;
    for (const glm::uvec2 size : {glm::uvec2(most + 1, 1), glm::uvec2(1, most + 1), glm::uvec2(UINT32_MAX, UINT32_MAX)})
        findings.push_back(isRefused(fmt::format("{}x{}", size.x, size.y), fmt::format("{}x{}", most, most),
                                     [&] { lab.render(scene, stabilitySettings(size.x, size.y)); }));
    return findings;
}

Findings vplCounts(StabilityLab& lab) {
    // A furnace: the picture is the same with any number of VPLs, and of paths. 0 leaves two terms of the series.
    Findings findings;
    const Scene scene = normalise(closedRoom(0.5, 1.0));
    RenderSettings settings = withClamp(stabilitySettings(8, 8), ClampMode::Compensate);
    Renderer renderer(lab.device(), scene, settings, lab.pipelines());
    settings.vplCount = 0;
    findings.push_back(meanIs("no VPL", lab.means(renderer, withClamp(settings, ClampMode::Off)), 1.5, 0.03));
    for (const uint32_t count : {1u, 7u, 127u, 129u, 1000u, 4099u}) {
        settings.vplCount = count;
        settings.pathCount = 0;
        // A single VPL is a sample of all depths: its pictures scatter by a third of their mean.
        findings.push_back(
            meanIs(fmt::format("{} VPLs", count), lab.means(renderer, settings, 16, count < 8 ? 16 : 2), 2.0, 0.03));
    }
    settings.vplCount = 100;
    for (const uint32_t paths : {1u, 33u, 5000u}) {
        settings.pathCount = paths;
        findings.push_back(meanIs(fmt::format("100 VPLs of {} paths", paths),
                                  lab.means(renderer, settings, 16, paths == 1 ? 16 : 4), 2.0, 0.05));
    }
    settings.vplCount = UINT32_MAX;
    settings.pathCount = 0;
    findings.push_back(isRefused("4294967295 VPLs", "VPLs", [&] { lab.render(renderer, settings); }));
    return findings;
}

Findings millionVpls(StabilityLab& lab) {
    Findings findings;
    const Scene scene = normalise(closedRoom(0.5, 1.0));
    RenderSettings settings = stabilitySettings(4, 4);
    settings.lighting = Lighting::Global;
    settings.castShadows = false;  // a convex room has none
    for (const uint32_t count : {1u << 20, (1u << 20) + 1u}) {
        settings.vplCount = count;
        // One picture: with 65536 VPLs it is 0.5 % off, and the error falls by four.
        findings.push_back(closeTo(fmt::format("{} VPLs: light but the first bounce's", count),
                                   meanOf(lab.render(scene, settings)), 0.5, 5e-3));
    }
    return findings;
}

Findings millionsOfTriangles(StabilityLab& lab) {
    // The same room in 12 triangles and in five million: plane walls stay plane.
    constexpr uint32_t kCells = 646;  // 6 walls x 2 x 646^2 = 5,007,792
    const RenderSettings settings = withClamp(stabilitySettings(24, 18), ClampMode::Compensate);
    const Image reference = lab.render(litRoom(1), settings);
    const Scene scene = litRoom(kCells);
    Findings findings;
    findings.push_back(countIs("triangles", scene.triangles.size(), 12u * kCells * kCells));
    // Corners of the grid are rounded to single precision: a wall is plane to 3e-8, and points on it are as exact.
    findings.push_back(closePictures("deferred, 12 triangles", lab.render(scene, settings), reference, 1e-4));
    return findings;
}

Findings bandsOfDispatches(StabilityLab& lab) {
    // Shaded in bands of 8 rows, each below the bound on a dispatch; forward shading knows no bands.
    RenderSettings settings = stabilitySettings(8192, 24);
    settings.vplCount = 256;
    settings.bounceCount = 2;
    const Scene scene = normalise(closedRoom(0.5, 1.0));
    const Image deferred = lab.render(scene, settings);
    Findings findings;
    findings.push_back(closePictures("8192x24 in bands, forward",
                                     lab.render(scene, withTechnique(settings, Technique::Forward)), deferred,
                                     1e-5));  // G-buffer: albedo in steps of 2^-21, rounded normals
    return findings;
}

}  // namespace manylight::stability
