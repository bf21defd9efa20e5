#include "engine/scene/import.h"

#include "engine/core/error.h"
#include "engine/scene/animated_scene.h"
#include "engine/scene/gltf.h"
#include "engine/scene/normalise.h"
#include "engine/scene/obj.h"
#include "engine/scene/scene_file.h"
#include "engine/scene/sidecar.h"

#include <algorithm>
#include <cctype>
#include <chrono>

namespace manylight {

SceneFileKind sceneFileKind(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (extension == ".obj") return SceneFileKind::Obj;
    if (extension == ".gltf" || extension == ".glb") return SceneFileKind::Gltf;
    if (extension == ".json") return SceneFileKind::Sidecar;
    return SceneFileKind::Unknown;
}

RawScene readSceneFile(const std::filesystem::path& path, const ImportOptions& options) {
    switch (sceneFileKind(path)) {
        case SceneFileKind::Obj:
            return options.placesOnly ? RawScene{} : readObj(path);  // nothing in it moves
        case SceneFileKind::Gltf:
            return readGltf(path, options);
        case SceneFileKind::Sidecar:
            return readSidecar(path, options);
        case SceneFileKind::Unknown:
            break;
    }
    fail("{}: unknown kind of scene, expected .obj, .gltf, .glb or a .json sidecar", path.string());
}

namespace {

/// A moment that a sidecar asks for looks as it does where the animation is played: in the frame of all its motion.
Scene readAndNormalise(const std::filesystem::path& path, ImportOptions options) {
    const std::optional<double> moment = options.time ? std::nullopt : savedMoment(path);
    if (!moment) return normalise(readSceneFile(path, options));
    std::shared_ptr<const GltfFile> opened;
    if (options.opened == nullptr) options.opened = &opened;
    const double end = animationEndOf(path, options);
    if (end <= 0.0) return normalise(readSceneFile(path, options));
    return AnimatedScene(path, options, samplesOfMotion(end), std::min(*moment, end)).release();
}

}  // namespace

Scene importScene(const std::filesystem::path& path, const ImportOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    Scene scene = readAndNormalise(path, options);
    scene.importReport["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return scene;
}

}  // namespace manylight
