// Scenes with little or nothing in them.
#include "apps/bench/stability/families.h"
#include "apps/bench/stability/lab.h"
#include "apps/bench/stability/scenes.h"
#include "shaders/shared/constants.h"

namespace manylight::stability {
namespace {

constexpr Technique kTechniques[] = {Technique::Deferred, Technique::Forward, Technique::ForwardPrepass,
                                     Technique::PathTracer};

void addBlack(StabilityLab& lab, Findings& findings, const std::string& what, RawScene raw) {
    const Scene scene = normalise(std::move(raw));
    Renderer renderer(lab.device(), scene, stabilitySettings(8, 8), lab.pipelines());
    for (const Technique technique : kTechniques)
        findings.push_back(allZero(fmt::format("{}, {}", what, name(technique)),
                                   lab.render(renderer, withTechnique(stabilitySettings(8, 8), technique))));
}

}  // namespace

Findings nothingToSee(StabilityLab& lab) {
    Findings findings;
    addBlack(lab, findings, "nothing at all", emptyScene());
    addBlack(lab, findings, "no light", closedRoom(0.5));
    RawScene noGeometry = emptyScene();
    addPointLight(noGeometry, {0, 0, 0}, glm::dvec3(1.0));
    addBlack(lab, findings, "no geometry", std::move(noGeometry));
    RawScene degenerate = closedRoom(0.5);
    addTriangle(degenerate, {0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0},
                addMaterial(degenerate, glm::dvec3(0.5), glm::dvec3(1.0)));
    addBlack(lab, findings, "degenerate emitters", std::move(degenerate));
    RawScene away = emptyScene();
    addQuad(away, {-0.5, 0, -0.5}, {0, 0, 1}, {1, 0, 0}, addMaterial(away, glm::dvec3(0.5)));
    addPointLight(away, {0, 0.2, 0}, glm::dvec3(1.0));
    addCamera(away, {0, 0.5, 0}, {0, 1.5, 0}, 1.0);
    addBlack(lab, findings, "nothing in view", std::move(away));
    return findings;
}

Findings oneTriangle(StabilityLab& lab) {
    RawScene raw = emptyScene();
    addTriangle(raw, {-1, 0, 1}, {1, 0, 1}, {0, 0, -1}, addMaterial(raw, glm::dvec3(0.5)));
    addPointLight(raw, {0, 0.5, 0}, glm::dvec3(1.0));
    addCamera(raw, {0, 1, 0.5}, {0, 0, 0}, 1e-3);
    const Scene scene = normalise(std::move(raw));
    Findings findings;
    const double expected = 0.5 / double{shared::kPi} / 0.25;  // albedo / pi * I / d^2
    for (const Technique technique : kTechniques)
        findings.push_back(closeTo(fmt::format("lit from above, {}", name(technique)),
                                   meanOf(lab.render(scene, withTechnique(stabilitySettings(1, 1), technique))),
                                   expected, 1e-5));  // G-buffer: albedo in steps of 2^-21; rounding of d^2
    return findings;
}

Findings cameraInWall(StabilityLab& lab) {
    Findings findings;
    RawScene raw = furnishedRoom();
    raw.cameras.clear();
    addCamera(raw, {-0.5, 0.0, 0.0}, {0.5, 0.0, 0.0}, 1.0);    // in the plane of a wall, into the room
    addCamera(raw, {-0.5, 0.0, 0.0}, {-1.5, 0.0, 0.0}, 1.0);   // and out of it
    addCamera(raw, {-0.5, 0.0, 0.0}, {-0.5, 0.5, 0.1}, 1.0);   // and along it
    addCamera(raw, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, 1.0);  // in a corner
    addCamera(raw, {0.2, -0.3, -0.1}, {0.5, 0.0, 0.0}, 1.0);   // in a closed solid
    const Scene scene = normalise(std::move(raw));
    Renderer renderer(lab.device(), scene, stabilitySettings(12, 9), lab.pipelines());
    for (const Technique technique : kTechniques) {
        RenderSettings settings = withTechnique(stabilitySettings(12, 9), technique);
        std::string error;
        for (settings.camera = 0; settings.camera < 4 && error.empty(); ++settings.camera)
            error = errorOf([&] { lab.render(renderer, settings); });
        findings.push_back(holds(fmt::format("on walls, {}", name(technique)), "finite",
                                 error.empty() ? "finite" : error, error.empty()));
        settings.camera = 4;
        findings.push_back(allZero(fmt::format("in a solid, {}", name(technique)), lab.render(renderer, settings)));
    }
    return findings;
}

}  // namespace manylight::stability
