#include "engine/scene/generate/forest.h"

#include "engine/core/file.h"
#include "engine/scene/generate/generated_scene.h"
#include "engine/scene/generate/gltf_text.h"
#include "engine/scene/generate/random.h"
#include "engine/scene/generate/shapes.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

constexpr double kTreeSpacing = 3.4;  // metres, on average
constexpr double kLampSpacing = 9.0;
constexpr glm::dvec3 kLampRadiance{900.0, 650.0, 330.0};

/// A rhombus in a crown of the given half height and radius, at height `middle`.
void addLeaf(Mesh& mesh, uint32_t material, double middle, const glm::dvec3& radii, double halfWidth,
             SceneRandom& random) {
    const glm::dvec3 out = uniformDirection(random);
    const glm::dvec3 center = glm::dvec3(0, middle, 0) + radii * out * std::sqrt(random.between(0.1, 1.0));
    const glm::dvec3 normal = glm::normalize(out + 1.2 * uniformDirection(random));
    const glm::dvec3 helper = std::abs(normal.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 width = halfWidth * glm::normalize(glm::cross(helper, normal));
    const glm::dvec3 length = 2.0 * glm::cross(normal, width);
    addQuad(mesh, material, {center - length, center + width, center + length, center - width});
}

Mesh tree(uint32_t triangles, SceneRandom& random) {
    Mesh mesh;
    const uint32_t bark = addMaterial(mesh, "bark", {0.16, 0.11, 0.07});
    const uint32_t leaf =
        addMaterial(mesh, "leaf", {random.between(0.08, 0.3), random.between(0.3, 0.45), random.between(0.05, 0.12)});
    const double height = random.between(2.2, 3.2);
    beginObject(mesh, "trunk");
    addLathe(mesh, {}, {{0.18, 0.0}, {0.12, 0.5}, {0.1, 0.6 * height}, {0.05, height}}, 10, bark);
    beginObject(mesh, "leaves", false);
    const size_t trunk = triangleCount(mesh);
    const glm::dvec3 radii(random.between(0.9, 1.4), 0.45 * height, random.between(0.9, 1.4));
    const size_t leaves = triangles > trunk ? (triangles - trunk) / 2 : 1;
    const double halfWidth = 0.9 / std::sqrt(static_cast<double>(leaves) / 100.0);
    for (size_t i = 0; i < leaves; ++i) addLeaf(mesh, leaf, 0.85 * height, radii, 0.25 * halfWidth, random);
    return mesh;
}

Mesh lamp() {
    Mesh mesh;
    const uint32_t glass = addMaterial(mesh, "lamp", glm::dvec3(0.0), kLampRadiance);
    beginObject(mesh, "lamp");
    addSphere(mesh, {}, 0.12, 0.12, 8, glass);
    return mesh;
}

Mesh ground(double half) {
    Mesh mesh;
    const uint32_t soil = addMaterial(mesh, "soil", {0.2, 0.17, 0.1});
    beginObject(mesh, "ground", false);
    addQuad(mesh, soil, {{{-half, 0, half}, {half, 0, half}, {half, 0, -half}, {-half, 0, -half}}});
    return mesh;
}

/// Trees on a jittered grid of side * side places, one kind after the other by chance.
void plantTrees(GltfText& gltf, const std::vector<size_t>& kinds, uint64_t count, double half, SceneRandom& random) {
    const auto side = static_cast<uint64_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    const double step = 2.0 * half / static_cast<double>(side);
    for (uint64_t i = 0; i < count; ++i) {
        const double x = -half + step * (static_cast<double>(i % side) + random.between(0.15, 0.85));
        const double z = -half + step * (static_cast<double>(i / side) + random.between(0.15, 0.85));
        const double width = random.between(0.8, 1.25);
        // Some lean to one side, and every fifth is a mirror image.
        const glm::dvec3 scale(i % 5 == 0 ? -width : width, width * random.between(0.85, 1.3), width);
        addGltfNode(gltf, kinds[random.below(static_cast<uint32_t>(kinds.size()))],
                    turned({x, 0, z}, uniformAngle(random)), scale);
    }
}

void hangLamps(GltfText& gltf, size_t mesh, double half, SceneRandom& random) {
    const auto side = static_cast<uint32_t>(std::max(1.0, std::floor(2.0 * half / kLampSpacing)));
    const double step = 2.0 * half / side;
    for (uint32_t i = 0; i < side * side; ++i) {
        const glm::dvec3 place(-half + step * (i % side + 0.5), random.between(1.2, 2.6),
                               -half + step * (i / side + 0.5));
        addGltfNode(gltf, mesh, turned(place, 0.0), glm::dvec3(random.between(0.7, 1.5)));
    }
}

Json sidecarOf(double half) {
    return {{"name", "forest"},
            {"scene", "forest.gltf"},
            {"camera",
             {{"origin", {0.0, 0.22 * half + 3.0, 1.12 * half}},
              {"target", {0.0, 0.5, 0.2 * half}},
              {"fov_y_deg", 45.0},
              {"width", 512},
              {"height", 384}}},
            {"lights", {{{"type", "constant"}, {"radiance", {0.06, 0.09, 0.18}}}}}};
}

}  // namespace

ForestFiles writeForest(const ForestParameters& parameters, const std::filesystem::path& folder) {
    SceneRandom random(parameters.seed);
    GltfText gltf;
    gltf.json["extensionsUsed"] = {"KHR_materials_specular", "KHR_materials_emissive_strength"};
    ForestFiles files;
    std::vector<size_t> kinds;
    for (uint32_t i = 0; i < std::max(parameters.kinds, 1u); ++i) {
        const Mesh mesh = tree(parameters.treeTriangles, random);
        files.trianglesStored += triangleCount(mesh);
        kinds.push_back(addGltfMesh(gltf, mesh, "tree"));
    }
    const uint64_t count = std::max<uint64_t>(1, parameters.triangleTarget / std::max(parameters.treeTriangles, 1u));
    const double half = std::max(kTreeSpacing, 0.5 * kTreeSpacing * std::sqrt(static_cast<double>(count)));
    plantTrees(gltf, kinds, count, half, random);
    hangLamps(gltf, addGltfMesh(gltf, lamp(), "lamp"), half, random);
    addGltfNode(gltf, addGltfMesh(gltf, ground(1.2 * half), "ground"), {}, glm::dvec3(1.0));
    files.trianglesShown = count * parameters.treeTriangles;

    createSceneFolder(folder);
    gltf.json["buffers"] = {{{"byteLength", gltf.bytes.size()}, {"uri", "forest.bin"}}};
    const auto write = [&](const char* name, const std::string& text) {
        writeTextFile(folder / name, text);
        files.written.push_back(folder / name);
    };
    write("forest.bin", gltf.bytes);
    write("forest.gltf", gltf.json.dump() + "\n");
    write("forest.json", sidecarOf(half).dump(2) + "\n");
    return files;
}

}  // namespace manylight
