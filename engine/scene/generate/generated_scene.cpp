#include "engine/scene/generate/generated_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <system_error>

#include "engine/core/error.h"
#include "engine/core/file.h"

namespace manylight {

namespace {

namespace fs = std::filesystem;

void appendVectors(fmt::memory_buffer& text, const char* keyword, const std::vector<glm::dvec3>& vectors) {
    for (const glm::dvec3& v : vectors)
        fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", keyword, v.x, v.y, v.z);
}

/// Indices of an OBJ file count from one; a face with normals is written v//vn.
void appendFace(fmt::memory_buffer& text, const MeshFace& face) {
    text.push_back('f');
    for (uint32_t corner = 0; corner < face.cornerCount(); ++corner) {
        fmt::format_to(std::back_inserter(text), " {}", face.position[corner] + 1);
        if (face.normal[corner] != kNoIndex) fmt::format_to(std::back_inserter(text), "//{}", face.normal[corner] + 1);
    }
    text.push_back('\n');
}

/// One line, or one line for each object of a list.
std::string entryText(const Json& value) {
    if (!value.is_array() || value.empty() || !value.front().is_object()) return value.dump();
    std::vector<std::string> lines;
    for (const Json& element : value) lines.push_back("    " + element.dump());
    return fmt::format("[\n{}\n  ]", fmt::join(lines, ",\n"));
}

}  // namespace

std::string objText(const GeneratedScene& scene) {
    const Mesh& mesh = scene.mesh;
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    for (const std::string& comment : scene.comments) fmt::format_to(out, "# {}\n", comment);
    fmt::format_to(out, "mtllib {}.mtl\n", scene.name);
    appendVectors(text, "v", mesh.positions);
    appendVectors(text, "vn", mesh.normals);

    size_t nextObject = 0;
    uint32_t material = kNoIndex;
    for (size_t i = 0; i < mesh.faces.size(); ++i) {
        for (; nextObject < mesh.objects.size() && mesh.objects[nextObject].firstFace == i; ++nextObject)
            fmt::format_to(out, "g {}\n", mesh.objects[nextObject].name);
        if (mesh.faces[i].material != material) {
            material = mesh.faces[i].material;
            fmt::format_to(out, "usemtl {}\n", mesh.materials[material].name);
        }
        appendFace(text, mesh.faces[i]);
    }
    return fmt::to_string(text);
}

std::string mtlText(const GeneratedScene& scene) {
    std::string text =
        fmt::format("# materials of {}.obj: linear Rec.709 reflectances, Ke in W / (sr m^2)\n", scene.name);
    for (const MeshMaterial& material : scene.mesh.materials) {
        const glm::dvec3& albedo = material.albedo;
        const glm::dvec3& emission = material.emittedRadiance;
        text += fmt::format("\nnewmtl {}\nKd {} {} {}\n", material.name, albedo.r, albedo.g, albedo.b);
        if (emission != glm::dvec3(0.0)) text += fmt::format("Ke {} {} {}\n", emission.r, emission.g, emission.b);
    }
    return text;
}

std::string sidecarText(const GeneratedScene& scene) {
    Json sidecar{{"name", scene.name}, {"scene", fmt::format("{0}/{0}.obj", scene.name)}};
    sidecar.update(scene.sidecar);

    std::vector<std::string> entries;
    for (auto it = sidecar.begin(); it != sidecar.end(); ++it)
        entries.push_back(fmt::format("  \"{}\": {}", it.key(), entryText(*it)));
    return fmt::format("{{\n{}\n}}\n", fmt::join(entries, ",\n"));
}

std::vector<fs::path> writeGeneratedScene(const GeneratedScene& scene, const fs::path& folder) {
    const fs::path meshFolder = folder / scene.name;
    createSceneFolder(meshFolder);
    std::vector<fs::path> written;
    const auto write = [&](const fs::path& path, const std::string& text) {
        writeTextFile(path, text);
        written.push_back(path);
    };
    if (scene.hasMaterialFile) write(meshFolder / (scene.name + ".mtl"), mtlText(scene));
    write(meshFolder / (scene.name + ".obj"), objText(scene));
    write(folder / (scene.name + ".json"), sidecarText(scene));
    return written;
}

void createSceneFolder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) fail("{}: cannot create folder: {}", folder.string(), error.message());
}

Json toJson(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

}  // namespace manylight
