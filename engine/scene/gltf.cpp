#include "engine/scene/gltf.h"

#include "engine/core/error.h"
#include "engine/scene/gltf_check.h"
#include "engine/scene/gltf_container.h"
#include "engine/scene/gltf_materials.h"
#include "engine/scene/gltf_nodes.h"

#include <algorithm>

namespace manylight {
namespace {

/// What tinygltf is to see. Buffers and images are opened by us (it trusts their sizes, expands their names in a shell
/// and gives up on one it does not need); animations and skins we read ourselves.
Json forTinygltf(const Json& checked) {
    Json json = checked;
    for (const char* key : {"buffers", "images", "animations", "skins"}) json.erase(key);
    if (!json.contains("accessors")) return json;
    // It insists on a buffer view for indices: an extra one past the file's own stands for "none".
    const int noView = static_cast<int>(json.contains("bufferViews") ? json["bufferViews"].size() : 0);
    json["bufferViews"].push_back({{"buffer", 0}, {"byteLength", 1}});
    for (Json& accessor : json["accessors"]) {
        if (!accessor.contains("bufferView")) accessor["bufferView"] = noView;
        if (gltfComponentCount(accessor["type"].get<std::string>()) == 0) accessor["type"] = "SCALAR";
    }
    return json;
}

/// Nodes and instances repeat what is stored once, and an accessor may have no data at all: a few bytes could ask for
/// any amount of memory. A byte may stand for 256 vertices (3000 copies of every vertex, at 12 bytes), and any file for
/// a million more.
size_t mostElementsFor(size_t byteCount) {
    constexpr size_t kPerByte = 256;
    constexpr size_t kPerFile = size_t{1} << 20;
    return std::min(kPerFile + kPerByte * byteCount, size_t{UINT32_MAX});
}

/// tinygltf leaves out what it cannot parse; nothing may be missing.
void checkNothingLost(const GltfFile& gltf) {
    const Json& json = gltf.container.json;
    if (!json.contains("meshes")) return;
    for (size_t i = 0; i < gltf.model.meshes.size(); ++i)
        if (gltf.model.meshes[i].primitives.size() != json["meshes"][i]["primitives"].size())
            fail("{}: meshes[{}]: a primitive cannot be read", gltf.container.file, i);
}

void dropUnusedDefaultMaterial(RawScene& scene) {
    const auto last = static_cast<uint32_t>(scene.materials.size() - 1);
    const auto usesIt = [&](const RawTriangle& triangle) { return triangle.material == last; };
    bool isUsed = std::ranges::any_of(scene.triangles, usesIt);
    for (const RawMesh& mesh : scene.meshes) isUsed = isUsed || std::ranges::any_of(mesh.triangles, usesIt);
    if (!isUsed) scene.materials.pop_back();
}

tinygltf::Model parseModel(const GltfContainer& container) {
    const std::string text = forTinygltf(container.json).dump(-1, ' ', true, Json::error_handler_t::replace);
    tinygltf::Model model;
    tinygltf::TinyGLTF parser;
    std::string error;
    std::string warning;
    const bool isRead =
        parser.LoadASCIIFromString(&model, &error, &warning, text.data(), static_cast<unsigned int>(text.size()), "");
    std::replace(error.begin(), error.end(), '\n', ' ');
    if (!isRead) fail("{}: not readable as glTF: {}", container.file, error);
    return model;
}

std::shared_ptr<const GltfFile> open(const std::filesystem::path& path) {
    const auto gltf = std::make_shared<GltfFile>();
    gltf->container = openGltf(path, gltf->warnings);
    checkGltf(JsonView(gltf->container.json, gltf->container.file), gltf->warnings);
    loadGltfBuffers(gltf->container, gltf->warnings);
    gltf->mostElements = mostElementsFor(gltf->container.byteCount);
    gltf->model = parseModel(gltf->container);
    if (gltf->container.json.contains("bufferViews")) gltf->viewCount = gltf->container.json["bufferViews"].size();
    checkNothingLost(*gltf);
    return gltf;
}

}  // namespace

RawScene readGltf(const std::filesystem::path& path, const ImportOptions& options) {
    RawScene scene;
    scene.name = path.stem().string();
    scene.path = path;
    std::shared_ptr<const GltfFile> gltf = options.opened ? *options.opened : nullptr;
    if (!gltf) gltf = open(path);
    if (options.opened) *options.opened = gltf;
    scene.warnings.merge(gltf->warnings);
    if (!options.time && gltf->container.json.contains("animations"))
        scene.warnings.add("animations ignored: nodes keep their rest pose", {},
                           gltf->container.json["animations"].size());
    if (!options.placesOnly) addGltfMaterials(*gltf, scene);
    addGltfNodes(*gltf, options, scene);
    if (!options.placesOnly) dropUnusedDefaultMaterial(scene);
    return scene;
}

}  // namespace manylight
