// Where no light can arrive, none does: not little, but zero.
#include "apps/bench/stability/families.h"
#include "apps/bench/stability/lab.h"
#include "apps/bench/stability/scenes.h"

#include <fmt/format.h>

namespace manylight::stability {
namespace {

/// Every way of shading: what it must show from a dark place, and from a lit one.
void addDarkAndLit(StabilityLab& lab, Findings& findings, const std::string& what, const Scene& scene,
                   uint32_t litCamera, const std::vector<uint32_t>& darkCameras) {
    RenderSettings settings = stabilitySettings(16, 12);
    Renderer renderer(lab.device(), scene, settings, lab.pipelines());
    struct Way {
        Technique technique;
        ClampMode clamp;
    };
    for (const Way way : {Way{Technique::Deferred, ClampMode::Off}, Way{Technique::Deferred, ClampMode::Compensate},
                          Way{Technique::Forward, ClampMode::Off}, Way{Technique::PathTracer, ClampMode::Off}}) {
        settings = withClamp(withTechnique(settings, way.technique), way.clamp);
        settings.camera = litCamera;
        const Finding lit = notBlack(what, lab.render(renderer, settings, 2));
        if (lit.verdict == Verdict::Fails) findings.push_back(lit);
        for (const uint32_t camera : darkCameras) {
            settings.camera = camera;
            findings.push_back(allZero(fmt::format("{}, {}, clamp {}", what, name(way.technique), name(way.clamp)),
                                       lab.render(renderer, settings, 2)));
        }
    }
}

/// Two closed rooms back to back, `thickness` apart; 0: one room with a single sheet across. All light is in the left
/// one, on its side of the wall. Camera 0 is in the dark room, camera 1 in the lit one.
Scene backToBack(double thickness) {
    RawScene raw = emptyScene();
    const uint32_t white = addMaterial(raw, glm::dvec3(0.8));
    if (thickness == 0.0) {
        addRoom(raw, {-0.5, -0.25, -0.25}, {0.5, 0.25, 0.25}, white);
        addQuad(raw, {0, -0.25, -0.25}, {0, 0.5, 0}, {0, 0, 0.5}, white);
    } else {
        addRoom(raw, {-0.5, -0.25, -0.25}, {-thickness / 2.0, 0.25, 0.25}, white);
        addRoom(raw, {thickness / 2.0, -0.25, -0.25}, {0.5, 0.25, 0.25}, white);
    }
    addQuad(raw, {-0.3, 0.2, -0.05}, {0.1, 0, 0}, {0, 0, 0.1}, addMaterial(raw, glm::dvec3(0.0), glm::dvec3(10.0)));
    addPointLight(raw, {-0.01, 0.1, 0.1}, glm::dvec3(1.0));
    addPointLight(raw, {-0.005, -0.245, -0.245}, glm::dvec3(1.0));  // in the corner of wall and floor
    addCamera(raw, {0.45, 0.1, 0.2}, {0.0, -0.1, -0.1}, 1.4);
    addCamera(raw, {-0.45, 0.1, 0.2}, {0.0, -0.1, -0.1}, 1.4);
    return normalise(std::move(raw));
}

}  // namespace

Findings thinWalls(StabilityLab& lab) {
    Findings findings;
    for (const double thickness : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 0.0})
        addDarkAndLit(lab, findings, fmt::format("wall of {:.0e}", thickness), backToBack(thickness), 1, {0});
    return findings;
}

Findings nestedBoxes(StabilityLab& lab) {
    RawScene raw = emptyScene();
    const uint32_t white = addMaterial(raw, glm::dvec3(0.8));
    addRoom(raw, glm::dvec3(-0.5), glm::dvec3(0.5), white);
    addRoom(raw, {-0.3, -0.5, -0.3}, {0.3, 0.1, 0.3}, white);  // its floor is the outer one's
    addRoom(raw, {-0.2, -0.4, -0.2}, {0.2, 0.0, 0.2}, white);
    addPointLight(raw, {0.0, -0.2, 0.0}, glm::dvec3(1.0));
    addCamera(raw, {0.1, -0.1, 0.1}, {-0.1, -0.3, -0.1}, 1.2);
    addCamera(raw, {0.25, 0.05, 0.25}, {0.0, -0.2, 0.0}, 1.2);
    addCamera(raw, {0.45, 0.45, 0.45}, {0.0, -0.2, 0.0}, 1.2);
    Findings findings;
    addDarkAndLit(lab, findings, "boxes in boxes", normalise(std::move(raw)), 0, {1, 2});
    return findings;
}

Findings opposedNormals(StabilityLab& lab) {
    // A lamp in a coarse closed sphere: with normals of a smooth one, of a smooth one turned inside out, and none.
    Findings findings;
    struct Kind {
        const char* what;
        bool smooth;
        double sign;
    };
    for (const Kind kind : {Kind{"coarse sphere, flat", false, 1.0}, Kind{"coarse sphere, smooth", true, 1.0},
                            Kind{"coarse sphere, normals opposed", true, -1.0}}) {
        RawScene raw = emptyScene();
        const uint32_t white = addMaterial(raw, glm::dvec3(0.8));
        addSphere(raw, {-0.1, 0.0, 0.0}, 0.2, 1, false, kind.smooth, white);
        for (RawVertex& vertex : raw.vertices) vertex.normal *= kind.sign;
        addRoom(raw, glm::dvec3(-0.5), glm::dvec3(0.5), white);
        addPointLight(raw, {-0.05, 0.02, 0.0}, glm::dvec3(1.0));
        addCamera(raw, {0.45, 0.2, 0.4}, {-0.1, 0.0, 0.0}, 1.0);
        addCamera(raw, {-0.1, 0.0, 0.1}, {-0.1, 0.0, -0.2}, 1.2);
        addDarkAndLit(lab, findings, kind.what, normalise(std::move(raw)), 1, {0});
    }
    return findings;
}

}  // namespace manylight::stability
