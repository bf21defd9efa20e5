// A generated scene: a mesh with its sidecar, and the text of the files that hold them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/report.h"
#include "engine/scene/generate/mesh.h"

namespace manylight {

struct GeneratedScene {
    std::string name;                   // stem of the files
    std::vector<std::string> comments;  // lines at the head of the OBJ file: what this is, and the source of its data
    Mesh mesh;
    bool hasMaterialFile = true;    // false: the OBJ names a material file that is not there
    Json sidecar = Json::object();  // "camera", "lights", ... ; the writer adds "name" and "scene"
};

std::string objText(const GeneratedScene& scene);
std::string mtlText(const GeneratedScene& scene);
std::string sidecarText(const GeneratedScene& scene);

/// Writes folder/name.json and, in folder/name/, name.obj and name.mtl, each atomically and the sidecar last; creates
/// the folders. Returns the paths written. Throws Error if that is impossible.
std::vector<std::filesystem::path> writeGeneratedScene(const GeneratedScene& scene,
                                                       const std::filesystem::path& folder);

/// With the folders above it. Throws Error if that is impossible.
void createSceneFolder(const std::filesystem::path& folder);

/// An array of three numbers for a sidecar.
Json toJson(const glm::dvec3& v);

}  // namespace manylight
