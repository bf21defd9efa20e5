// Files with what no file should have: repaired, counted, and not to be seen in the picture.
#include "apps/bench/stability/families.h"
#include "apps/bench/stability/lab.h"
#include "apps/bench/stability/scenes.h"
#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/scene/obj.h"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>

namespace manylight::stability {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Image picture(StabilityLab& lab, RawScene raw) {
    return lab.render(normalise(std::move(raw)), withClamp(stabilitySettings(24, 18), ClampMode::Compensate));
}

/// A folder that is gone with the object.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        const std::string random(6, 'X');  // what mkdtemp replaces
        std::string name = (std::filesystem::temp_directory_path() / ("manylight-stability-" + random)).string();
        if (!mkdtemp(name.data())) fail("{}: cannot create a folder", name);
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

Image pictureOfObj(StabilityLab& lab, const std::filesystem::path& file, const std::string& text, Warnings& warnings) {
    writeTextFile(file, text);
    RawScene raw = readObj(file);
    raw.lightsAreFinal = true;
    addPointLight(raw, {0.5, 1.5, 0.5}, glm::dvec3(1.0));
    addCamera(raw, {0.5, 1.0, 3.0}, {0.5, 0.2, 0.5}, 0.8);
    const Scene scene = normalise(std::move(raw));
    warnings = scene.warnings;
    return lab.render(scene, stabilitySettings(24, 18));
}

}  // namespace

Findings faultyEmitters(StabilityLab& lab) {
    const Image reference = picture(lab, furnishedRoom());
    Findings findings;
    RawScene raw = furnishedRoom();
    addTriangle(raw, {0, 0, 0}, {0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, addMaterial(raw, glm::dvec3(0.5), glm::dvec3(1e6)));
    addPointLight(raw, {0, 0, 0}, glm::dvec3(0.0));
    addPointLight(raw, {kNan, 0, 0}, glm::dvec3(1.0));
    addPointLight(raw, {0, 0, 0}, glm::dvec3(kInfinity));
    addPointLight(raw, {0, 0, 0}, glm::dvec3(-1.0, kNan, 0.0));
    raw.materials[0].emittedRadiance = {-1.0, kNan, -kInfinity};  // the walls
    const Scene scene = normalise(RawScene(raw));
    findings.push_back(sameBytes("no area, no light, NaN, negative", picture(lab, std::move(raw)), reference));
    findings.push_back(countIs("emissions repaired",
                               scene.warnings.count("emission channels set to zero: negative, not finite or too large"),
                               3));
    findings.push_back(
        countIs("lights dropped", scene.warnings.count("lights dropped: position or direction not usable"), 1));
    findings.push_back(countIs("triangles dropped", scene.warnings.count("triangles dropped: zero area"), 1));
    return findings;
}

Findings faultyNormals(StabilityLab& lab) {
    RawScene flat = furnishedRoom();
    for (RawVertex& vertex : flat.vertices) vertex.hasNormal = false;
    const Image reference = picture(lab, std::move(flat));
    Findings findings;
    uint64_t removed = 0;
    for (const glm::dvec3 normal : {glm::dvec3(0.0), glm::dvec3(kNan), glm::dvec3(kInfinity), glm::dvec3(1e-310)}) {
        RawScene raw = furnishedRoom();
        for (RawVertex& vertex : raw.vertices) {
            vertex.hasNormal = true;
            vertex.normal = normal;
        }
        removed += normalise(RawScene(raw)).warnings.count("vertex normals removed: zero, denormal or not finite");
        findings.push_back(
            sameBytes(fmt::format("all normals {}, none", normal.x), picture(lab, std::move(raw)), reference));
    }
    findings.push_back(holds("counted", "more than 0", fmt::format("{}", removed), removed > 0));
    return findings;
}

Findings faultyVertices(StabilityLab& lab) {
    const Image reference = picture(lab, furnishedRoom());
    RawScene raw = furnishedRoom();
    for (const double bad : {kNan, kInfinity, -kInfinity, 1e200})
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 corner(0.1);
            corner[axis] = bad;
            addTriangle(raw, corner, {0.2, 0, 0}, {0, 0.2, 0}, 0);
        }
    addTriangle(raw, {0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}, {0.3, 0.1, 0.1}, 0);  // a corner twice
    addTriangle(raw, {0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}, 0);  // on a line
    addTriangle(raw, {0.1, 0.1, 0.1}, {0.1 + 1e-12, 0.1, 0.1}, {0.1, 0.1 + 1e-12, 0.1},
                0);                                                // a point in single precision
    addTriangle(raw, {0, 0, 0}, {1e-30, 0, 0}, {0, 1e-30, 0}, 0);  // no point, but too small to be met
    addTriangle(raw, {0.1, 0, 0}, {0.1, 2e-20, 0}, {0.1, 0, 2e-20}, 0);
    raw.triangles.push_back({{0, 1, 4000000000u}, 0, 0});
    const Scene scene = normalise(RawScene(raw));
    Findings findings;
    findings.push_back(sameBytes("18 useless triangles, none", picture(lab, std::move(raw)), reference));
    uint64_t dropped = 0;
    for (const auto& [kind, entry] : scene.warnings.entries())
        if (kind.starts_with("triangles dropped")) dropped += entry.count;
    findings.push_back(countIs("dropped, two being triangles", dropped, 16));
    return findings;
}

Findings faultyAlbedos(StabilityLab& lab) {
    Findings findings;
    const auto room = [](glm::dvec3 albedo) {
        RawScene raw = closedRoom(0.0);
        raw.materials[0].albedo = albedo;
        addPointLight(raw, {0.1, 0.2, 0.1}, glm::dvec3(1.0));
        return raw;
    };
    RenderSettings settings = withClamp(stabilitySettings(), ClampMode::Compensate);
    findings.push_back(allZero("albedo 0", lab.render(normalise(room(glm::dvec3(0.0))), settings)));
    findings.push_back(sameBytes("albedo 1.5 and infinite, 1",
                                 lab.render(normalise(room({1.5, kInfinity, 7.0})), settings),
                                 lab.render(normalise(room(glm::dvec3(1.0))), settings)));
    findings.push_back(
        countIs("albedos repaired", normalise(room({1.5, 0, 0})).warnings.count("albedos clamped to [0, 1]"), 1));
    findings.push_back(sameBytes("albedo NaN and negative, 0", lab.render(normalise(room({kNan, -1, 0.5})), settings),
                                 lab.render(normalise(room({0, 0, 0.5})), settings)));
    // Nothing is absorbed: only the depth limit ends a path, and that is said.
    settings.vplCount = settings.pathCount = 64;
    const Scene white = normalise(room(glm::dvec3(1.0)));
    Renderer renderer(lab.device(), white, settings, lab.pipelines());
    findings.push_back(notBlack("albedo 1", lab.render(renderer, settings)));
    findings.push_back(countIs("  its paths cut off", renderer.status().pathsTruncated, 64));
    const Image red = lab.render(normalise(room({1.0, 0.0, 0.0})), settings);
    double others = 0.0;
    for (size_t i = 0; i < red.texels.size(); ++i)
        if (i % 3 != 0) others += double{red.texels[i]};
    findings.push_back(
        holds("albedo (1, 0, 0): green and blue", "exactly 0", fmt::format("{}", others), others == 0.0));
    findings.push_back(notBlack("  red", red));
    return findings;
}

Findings untidyObj(StabilityLab& lab) {
    const std::string tidy =
        "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 1 0\nv 1 1 0\n"
        "f 4 3 2\nf 4 2 1\nf 1 2 6\nf 1 6 5\n";
    const std::string untidy = std::string("# ") + std::string(100000, 'x') +
                               "\r\nmtllib absent.mtl\r\nusemtl absent\r\n"
                               "v\t0 0  0\r\nv 1 0 0 \r\nv 1.0 0e0 1\r\n\r\nv +0 -0 1\r\nv 0 1 0\r\nv 1 1 0\r\n"
                               "f -3 -4 -5 \\\r\n-6\r\nf 7 8 9\r\nf 1 2\r\nf\r\nnonsense 1 2 3\r\nf 1/ 2// 6 5";
    const TemporaryFolder folder;
    Warnings none;
    Warnings warnings;
    const Image reference = pictureOfObj(lab, folder.path() / "tidy.obj", tidy, none);
    const Image image = pictureOfObj(lab, folder.path() / "untidy.obj", untidy, warnings);
    Findings findings;
    findings.push_back(sameBytes("CRLF, tabs, negative indices, ...", image, reference));
    findings.push_back(notBlack("the picture", reference));
    std::string kinds;
    for (const auto& [kind, entry] : warnings.entries())
        kinds += fmt::format("{}{} {}", kinds.empty() ? "" : "; ", entry.count, kind);
    findings.push_back(holds("what was wrong is listed", "5 warnings at least", kinds, warnings.total() >= 5));
    return findings;
}

Findings injectedNan(StabilityLab& lab) {
    // Past normalise(), where no file can put it: what the passes write must give it away.
    Scene scene = normalise(furnishedRoom());
    RenderSettings settings = stabilitySettings();
    settings.checkFinite = true;
    Findings findings;
    for (const Technique technique : {Technique::Deferred, Technique::Forward, Technique::PathTracer}) {
        const auto render = [&] { lab.render(scene, withTechnique(settings, technique)); };
        scene = normalise(furnishedRoom());
        scene.materials[0].emittedRadiance = glm::vec3(std::numeric_limits<float>::quiet_NaN());
        findings.push_back(isRefused(fmt::format("NaN in a wall's light, {}", name(technique)), "not finite", render));
        scene = normalise(furnishedRoom());
        scene.materials[0].emittedRadiance = glm::vec3(std::numeric_limits<float>::infinity());
        findings.push_back(isRefused(fmt::format("infinity, {}", name(technique)), "not finite", render));
    }
    const Scene clean = normalise(furnishedRoom());
    for (const Technique technique :
         {Technique::Deferred, Technique::Forward, Technique::ForwardPrepass, Technique::PathTracer}) {
        const std::string error = errorOf([&] { lab.render(clean, withTechnique(settings, technique)); });
        findings.push_back(holds(fmt::format("no NaN, {}, --check-finite", name(technique)), "no error",
                                 error.empty() ? "none" : error, error.empty()));
    }
    return findings;
}

}  // namespace manylight::stability
