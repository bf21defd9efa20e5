#include "tests/fuzz/readers.h"

#include "engine/accel/bvh.h"
#include "engine/core/check.h"
#include "engine/image/image_io.h"
#include "engine/scene/import.h"
#include "engine/scene/scene_plan.h"
#include "tests/fuzz/companions.h"
#include "tests/fuzz/scene_check.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace manylight::fuzz {
namespace {

namespace fs = std::filesystem;

// Building costs more than all else; it only sees triangles that normalise() has let through.
constexpr size_t kMostTrianglesToBuild = 64;

/// A folder of this process, gone at its end.
class Folder {
  public:
    Folder() : path_(fs::temp_directory_path() / fmt::format("manylight_fuzz_{}", ::getpid())) {
        fs::create_directories(path_);
        for (const Companion& companion : companions()) write(companion.name, companion.content);
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    fs::path write(std::string_view name, std::string_view content) const {
        std::ofstream stream(path_ / name, std::ios::binary);
        stream.write(content.data(), static_cast<std::streamsize>(content.size()));
        stream.close();
        MANYLIGHT_CHECK(stream.good(), "{}", (path_ / name).string());
        return path_ / name;
    }
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

const Folder& folder() {
    static const Folder folder;
    return folder;
}

Outcome importFrom(const fs::path& path, const ImportOptions& options = {}) {
    const Scene scene = importScene(path, options);
    checkScene(scene);
    const std::string plan = explain(planScene(scene));
    MANYLIGHT_CHECK(plan.size() > 0u);
    const std::string report = scene.importReport.dump(-1, ' ', true, Json::error_handler_t::replace);
    MANYLIGHT_CHECK(report.size() > 0u);
    if (scene.triangles.size() <= kMostTrianglesToBuild) {
        const Bvh bvh = buildBvh(scene);
        MANYLIGHT_CHECK(bvh.triangleOrder.size() == scene.triangles.size());
        MANYLIGHT_CHECK(packTriangles(scene, bvh).size() == 3 * scene.triangles.size());
    }
    return {.error = {},
            .summary =
                fmt::format("{} triangles, {} textures, {} lights, {} cameras, {} warnings", scene.triangles.size(),
                            scene.textures.size(), scene.lights.size(), scene.cameras.size(), scene.warnings.total())};
}

Outcome readObjFile(std::string_view bytes) { return importFrom(folder().write("input.obj", bytes)); }

/// Through an OBJ file that uses what the input defines: see companions().
Outcome readMtlFile(std::string_view bytes) {
    folder().write("input.mtl", bytes);
    return importFrom(folder().path() / "uses_input.obj");
}

/// At rest, and in the middle of its animations.
Outcome importAnimated(const fs::path& path) {
    const Outcome atRest = importFrom(path);
    importFrom(path, {.time = 0.5});
    return atRest;
}

Outcome readGltfFile(std::string_view bytes) { return importAnimated(folder().write("input.gltf", bytes)); }
Outcome readGlbFile(std::string_view bytes) { return importAnimated(folder().write("input.glb", bytes)); }
Outcome readSidecarFile(std::string_view bytes) { return importFrom(folder().write("input.json", bytes)); }

Outcome readImageBytes(std::string_view bytes) {
    const auto* data = reinterpret_cast<const uint8_t*>(bytes.data());
    const EncodedImage image = readImage8(data, bytes.size(), "input");
    MANYLIGHT_CHECK(image.rgba.size() > 0u);
    MANYLIGHT_CHECK(image.rgba.size() == size_t{4} * image.width * image.height);
    return {.error = {}, .summary = fmt::format("{} x {} texels", image.width, image.height)};
}

Outcome readExrFile(std::string_view bytes) {
    const fs::path path = folder().write("input.exr", bytes);
    const size_t channels = exrChannelNames(path).size();
    const size_t attributes = readExrAttributes(path).size();
    const Image image = readExr(path);
    MANYLIGHT_CHECK(image.channels == 3u);
    MANYLIGHT_CHECK(image.texels.size() == size_t{3} * image.width * image.height);
    return {.error = {},
            .summary = fmt::format("{} x {} pixels, {} channels, {} attributes", image.width, image.height, channels,
                                   attributes)};
}

constexpr Reader kReaders[] = {{"obj", readObjFile}, {"mtl", readMtlFile},         {"gltf", readGltfFile},
                               {"glb", readGlbFile}, {"sidecar", readSidecarFile}, {"image", readImageBytes},
                               {"exr", readExrFile}};

}  // namespace

std::span<const Reader> readers() { return kReaders; }

Outcome readAndCheck(std::string_view readerName, std::string_view bytes) {
    const auto reader = std::ranges::find(kReaders, readerName, &Reader::name);
    MANYLIGHT_CHECK(reader != std::end(kReaders), "no reader of \"{}\"", readerName);
    Outcome outcome;
    try {
        outcome = reader->read(bytes);
    } catch (const Error& error) {
        outcome.error = error.what();
        const bool isOneLine = std::ranges::none_of(outcome.error, [](char c) { return c == '\n' || c == '\r'; });
        MANYLIGHT_CHECK(outcome.error.size() > 0u);
        MANYLIGHT_CHECK(isOneLine, "{}", outcome.error);
    }
    return outcome;
}

}  // namespace manylight::fuzz
