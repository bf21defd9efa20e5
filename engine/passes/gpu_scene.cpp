#include "engine/passes/gpu_scene.h"

#include "engine/core/check.h"
#include "engine/gpu/transfer.h"
#include "engine/passes/hardware_rays.h"
#include "engine/passes/pack_materials.h"
#include "engine/scene/texture_mean.h"
#include "shaders/shared/bindings.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

namespace manylight {
namespace {

/// Creates storage buffers and queues their content.
class SceneUploader {
  public:
    explicit SceneUploader(gpu::Device& device) : device_(device), uploader_(device) {}

    template <typename T>
    PhysicalBuffer upload(const char* name, const std::vector<T>& content, VkBufferUsageFlags usage,
                          VkFormat texelFormat = VK_FORMAT_UNDEFINED) {
        const auto bytes = std::as_bytes(std::span(content));
        if (texelFormat == VK_FORMAT_UNDEFINED && bytes.size() > device_.limits().maxStorageBufferRange)
            fail("the scene's {} take {} MiB, device {} allows {} MiB in one buffer", name, bytes.size() >> 20,
                 device_.info().name, device_.limits().maxStorageBufferRange >> 20);
        PhysicalBuffer buffer{
            gpu::Buffer(device_, name,
                        {bytes.size(), usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::MemoryKind::Device, texelFormat}),
            {}};
        uploader_.upload(buffer.buffer, bytes);
        return buffer;
    }
    /// Writes the start of a buffer anew.
    template <typename T>
    void renew(const PhysicalBuffer& buffer, const std::vector<T>& content) {
        uploader_.upload(buffer.buffer, std::as_bytes(std::span(content)));
    }
    void finish() { uploader_.flush(); }

  private:
    gpu::Device& device_;
    gpu::Uploader uploader_;
};

void measureSurfaces(GpuScene& gpuScene, const Scene& scene, const InstanceList& list) {
    std::vector<double> albedos;
    for (const Material& material : scene.materials) {
        glm::dvec3 albedo = material.albedo;
        if (material.albedoTexture.exists())
            albedo *= meanOfTexture(scene.textures[static_cast<size_t>(material.albedoTexture.texture)]);
        albedo += glm::dvec3(material.specular);
        albedos.push_back(std::min(std::max({albedo.x, albedo.y, albedo.z}), 1.0));
    }
    double albedoArea = 0.0;
    forEachTriangle(scene, list, [&](uint32_t, const Triangle& triangle, const std::array<glm::vec3, 3>& corners) {
        const glm::dvec3 p0 = corners[0];
        const double area = 0.5 * glm::length(glm::cross(glm::dvec3(corners[1]) - p0, glm::dvec3(corners[2]) - p0));
        gpuScene.surfaceArea += area;
        albedoArea += area * albedos[triangle.material];
    });
    gpuScene.meanAlbedo = gpuScene.surfaceArea > 0.0 ? static_cast<float>(albedoArea / gpuScene.surfaceArea) : 0.0f;
}

/// From the scene's order of triangles to the BVH's, and to the textures as they were packed.
void locateEmitters(EmitterTable& table, const Scene& scene, const std::vector<shared::Material>& materials,
                    const TriangleNumbers& numbers) {
    for (shared::Emitter& emitter : table.emitters) {
        if (emitter.kind != shared::kEmitterTriangle) continue;
        emitter.triangle = numbers.numberOfFlattened(emitter.triangle);
        const Triangle& triangle = scene.triangles[numbers.sceneTriangle(emitter.triangle)];
        emitter.emissionTexture = materials[triangle.material].emissionTexture;
    }
}

void uploadEmitters(GpuScene& gpuScene, const EnvironmentTable& environment, const ScenePlan& plan,
                    SceneUploader& uploader) {
    constexpr VkBufferUsageFlags kTexel = VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT;
    constexpr VkFormat kWords = VK_FORMAT_R32G32B32A32_UINT;
    const EmitterTable& table = gpuScene.emitterTable;
    gpuScene.emitters = uploader.upload("emitters", table.emitters, kTexel, kWords);
    gpuScene.emitterChoices = uploader.upload(
        "emitter choices", plan.manyEmitters ? table.choices : std::vector<shared::EmitterChoice>(), kTexel, kWords);
    gpuScene.environmentTexels =
        uploader.upload("environment texels", environment.texels, kTexel, VK_FORMAT_R32G32B32A32_SFLOAT);
    gpuScene.environmentCells = uploader.upload("environment cells", environment.cells, kTexel, kWords);
}

uint64_t emitterBytes(const GpuScene& gpuScene) {
    return gpuScene.emitters.buffer.size() + gpuScene.emitterChoices.buffer.size() +
           gpuScene.environmentTexels.buffer.size() + gpuScene.environmentCells.buffer.size();
}

/// One draw per mesh, which shows all its instances.
std::vector<DrawRange> drawsOf(const InstanceList& list) {
    std::vector<DrawRange> draws;
    for (uint32_t i = 0; i < list.instances.size();) {
        const uint32_t first = i;
        const uint32_t mesh = list.instances[i].mesh;
        while (i < list.instances.size() && list.instances[i].mesh == mesh) ++i;
        draws.push_back({3 * list.meshes[mesh].firstTriangle, 3 * list.meshes[mesh].triangleCount, first, i - first});
    }
    return draws;
}

/// The upper level and the records of instances; without two levels one record that nothing reads.
struct UpperLevel {
    std::vector<shared::BvhNode> nodes;  // one for each instance, as many as there may be
    std::vector<shared::Instance> instances{{}};
    uint32_t depth = 0;
};

/// Who visits no nodes asks for no leaves: any order of them will do.
TopLevel withoutNodes(const InstanceList& list) {
    TopLevel top;
    top.order.resize(list.instances.size());
    std::iota(top.order.begin(), top.order.end(), 0u);
    return top;
}

UpperLevel makeUpperLevel(const GpuScene& gpuScene, const InstanceList& list, const ScenePlan& plan) {
    if (gpuScene.instanceCount == 0) return {};
    TopLevel top = plan.hardwareRays ? withoutNodes(list) : buildTopLevel(gpuScene.instanceBounds);
    UpperLevel upper{.nodes = top.nodes, .instances = {}, .depth = top.depth};
    if (!plan.hardwareRays) upper.nodes.resize(list.instances.size());
    upper.instances = packInstances(list, gpuScene.meshRoots, top, static_cast<uint32_t>(upper.nodes.size()));
    return upper;
}

/// Fills the table of emitters, and returns that of the environment, which is part of it.
EnvironmentTable makeEmitters(GpuScene& gpuScene, const Scene& scene) {
    gpuScene.sphere = boundingSphere(scene);
    EnvironmentTable environment = buildEnvironmentTable(scene);
    gpuScene.environmentSize = environment.size;
    gpuScene.environmentCellSide = environment.cellSide;
    gpuScene.environmentTurn = environment.turn;
    gpuScene.emitterTable = buildEmitterTable(scene, gpuScene.sphere.radius, environment);
    locateEmitters(gpuScene.emitterTable, scene, gpuScene.packedMaterials, gpuScene.numbers);
    return environment;
}

}  // namespace

GpuScene uploadScene(gpu::Device& device, const Scene& scene, const ScenePlan& plan, const Bvh& bvh) {
    constexpr VkBufferUsageFlags kStorage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    constexpr VkBufferUsageFlags kTexel = VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT;
    std::vector<uint32_t> triangleMaterials;
    std::vector<glm::vec2> uvs;
    std::vector<glm::uvec2> colours;
    for (const uint32_t index : bvh.triangleOrder) {
        const Triangle& triangle = scene.triangles[index];
        triangleMaterials.push_back(triangle.material);
        for (const uint32_t corner : triangle.vertex) {
            const Vertex& vertex = scene.vertices[corner];
            if (plan.textured) uvs.push_back(vertex.uv);
            if (plan.textured && plan.uvSets > 1) uvs.push_back(vertex.uv1);
            if (plan.vertexColours)
                colours.emplace_back(glm::packUnorm2x16({vertex.colour.x, vertex.colour.y}),
                                     glm::packUnorm2x16({vertex.colour.z, vertex.colour.w}));
        }
    }
    const PackedMaterials packed = packMaterials(scene, plan);

    GpuScene gpuScene;
    const InstanceList list = listInstances(scene);
    gpuScene.triangleCount = list.triangleCount();
    gpuScene.instanceCount = plan.instanced ? static_cast<uint32_t>(list.instances.size()) : 0;
    gpuScene.draws = drawsOf(list);
    gpuScene.numbers = TriangleNumbers(list, bvh.triangleOrder);
    gpuScene.packedMaterials = packed.materials;
    const EnvironmentTable environment = makeEmitters(gpuScene, scene);
    measureSurfaces(gpuScene, scene, list);
    gpuScene.meshRoots = bvh.roots;
    if (plan.instanced) gpuScene.instanceBounds = boundsOfInstances(scene, list);
    const UpperLevel upper = makeUpperLevel(gpuScene, list, plan);
    std::vector<shared::BvhNode> nodes = upper.nodes;
    if (!plan.hardwareRays) appendNodes(nodes, bvh.nodes, 0);

    SceneUploader uploader(device);
    gpuScene.bvhNodes = uploader.upload("BVH nodes", nodes, kTexel, VK_FORMAT_R32G32B32A32_UINT);
    std::vector<glm::vec4> corners = packTriangles(scene, bvh);
    corners.resize(std::max<size_t>(corners.size(), 3));  // rays that meet nothing look at the first triangle
    const VkBufferUsageFlags forBuilds = plan.hardwareRays ? gpu::kUsageOfStructureInput : 0;
    gpuScene.triangles = uploader.upload("triangles", corners, kTexel | VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | forBuilds,
                                         VK_FORMAT_R32G32B32A32_UINT);
    gpuScene.triangleMaterials = uploader.upload("triangle materials", triangleMaterials, kStorage);
    gpuScene.triangleUvs = uploader.upload("triangle uvs", uvs, kStorage);
    gpuScene.triangleColours = uploader.upload("triangle colours", colours, kStorage);
    gpuScene.materials = uploader.upload("materials", packed.materials, kStorage);
    gpuScene.textureInfos = uploader.upload("texture infos", packed.textureInfos, kStorage);
    gpuScene.texels = uploader.upload("texels", packed.texels, kTexel, VK_FORMAT_R8G8B8A8_UNORM);
    uploadEmitters(gpuScene, environment, plan, uploader);
    gpuScene.instances = uploader.upload("instances", upper.instances, kTexel, VK_FORMAT_R32G32B32A32_UINT);
    uploader.finish();
    if (plan.hardwareRays) buildMeshStructures(device, gpuScene, scene, list);
    if (plan.hardwareRays) buildSceneStructure(device, gpuScene, list);

    gpuScene.bvhNodeCount = nodes.size();
    gpuScene.bvhDepth = plan.hardwareRays ? 0 : upper.depth + bvh.depth;
    gpuScene.treeDepth = bvh.depth;
    gpuScene.geometryBytes = gpuScene.bvhNodes.buffer.size() + gpuScene.triangles.buffer.size() +
                             gpuScene.triangleMaterials.buffer.size() + gpuScene.triangleUvs.buffer.size() +
                             gpuScene.triangleColours.buffer.size() + gpuScene.instances.buffer.size() +
                             structureBytes(gpuScene);
    gpuScene.totalBytes = gpuScene.geometryBytes + gpuScene.materials.buffer.size() +
                          gpuScene.textureInfos.buffer.size() + gpuScene.texels.buffer.size() + emitterBytes(gpuScene);
    return gpuScene;
}

void replaceEmitters(gpu::Device& device, GpuScene& gpuScene, const Scene& scene, const ScenePlan& plan) {
    gpuScene.totalBytes -= emitterBytes(gpuScene);
    const EnvironmentTable environment = makeEmitters(gpuScene, scene);
    SceneUploader uploader(device);
    if (updateEmission(gpuScene.packedMaterials, scene)) uploader.renew(gpuScene.materials, gpuScene.packedMaterials);
    uploadEmitters(gpuScene, environment, plan, uploader);
    uploader.finish();
    gpuScene.totalBytes += emitterBytes(gpuScene);
}

void moveInstances(gpu::Device& device, GpuScene& gpuScene, const Scene& scene, const ScenePlan& plan) {
    const InstanceList list = listInstances(scene);
    MANYLIGHT_CHECK(list.triangleCount() == gpuScene.triangleCount, "instances that moved");
    if (gpuScene.instanceCount > 0) {
        SceneUploader uploader(device);
        gpuScene.instanceBounds = boundsOfInstances(scene, list);
        const UpperLevel upper = makeUpperLevel(gpuScene, list, plan);
        uploader.renew(gpuScene.bvhNodes, upper.nodes);
        uploader.renew(gpuScene.instances, upper.instances);
        uploader.finish();
        if (plan.hardwareRays) buildSceneStructure(device, gpuScene, list);
    }
    replaceEmitters(device, gpuScene, scene, plan);
}

Json GpuScene::report() const {
    return {
        {"geometry_bytes", geometryBytes},
        {"geometry_bytes_per_triangle", triangleCount > 0 ? static_cast<double>(geometryBytes) / triangleCount : 0.0},
        {"scene_bytes", totalBytes},
        {"triangles", triangleCount},
        {"instances", instanceCount},
        {"bvh_nodes", bvhNodeCount},
        {"bvh_depth", bvhDepth},
        {"acceleration_structure_bytes", structureBytes(*this)}};
}

std::optional<BufferHandle> importStructure(FrameGraph& graph, GpuScene& scene) {
    if (!scene.accelerationStructure.buffer.exists()) return std::nullopt;
    return importPhysical(graph, "acceleration structure", scene.accelerationStructure);
}

SceneHandles importScene(FrameGraph& graph, GpuScene& scene, PhysicalBuffer& frame, PhysicalBuffer& status) {
    return {.frame = importPhysical(graph, "frame constants", frame),
            .status = importPhysical(graph, "status", status),
            .bvhNodes = importPhysical(graph, "BVH nodes", scene.bvhNodes),
            .triangles = importPhysical(graph, "triangles", scene.triangles),
            .triangleMaterials = importPhysical(graph, "triangle materials", scene.triangleMaterials),
            .triangleUvs = importPhysical(graph, "triangle uvs", scene.triangleUvs),
            .triangleColours = importPhysical(graph, "triangle colours", scene.triangleColours),
            .materials = importPhysical(graph, "materials", scene.materials),
            .textureInfos = importPhysical(graph, "texture infos", scene.textureInfos),
            .texels = importPhysical(graph, "texels", scene.texels),
            .emitters = importPhysical(graph, "emitters", scene.emitters),
            .emitterChoices = importPhysical(graph, "emitter choices", scene.emitterChoices),
            .environmentTexels = importPhysical(graph, "environment texels", scene.environmentTexels),
            .environmentCells = importPhysical(graph, "environment cells", scene.environmentCells),
            .instances = importPhysical(graph, "instances", scene.instances),
            .accelerationStructure = importStructure(graph, scene)};
}

void readFrame(PassBuilder& pass, const SceneHandles& scene, PipelineKind kind) {
    pass.read(scene.frame, kind == PipelineKind::Compute ? Access::ComputeUniform : Access::GraphicsUniform,
              shared::kBindingFrame);
}

void readSurfaces(PassBuilder& pass, const SceneHandles& scene, PipelineKind kind) {
    const bool compute = kind == PipelineKind::Compute;
    const Access texel = compute ? Access::ComputeTexelRead : Access::GraphicsTexelRead;
    const Access storage = compute ? Access::ComputeStorageRead : Access::GraphicsStorageRead;
    readFrame(pass, scene, kind);
    pass.read(scene.bvhNodes, texel, shared::kBindingBvhNodes)
        .read(scene.triangleMaterials, storage, shared::kBindingTriangleMaterials)
        .read(scene.triangleUvs, storage, shared::kBindingTriangleUvs)
        .read(scene.triangleColours, storage, shared::kBindingTriangleColours)
        .read(scene.materials, storage, shared::kBindingMaterials)
        .read(scene.textureInfos, storage, shared::kBindingTextureInfos)
        .read(scene.texels, texel, shared::kBindingTexels)
        .read(scene.instances, texel, shared::kBindingInstances)
        .read(scene.triangles, compute ? Access::ComputeTexelRead : Access::VertexAndTexels, shared::kBindingTriangles);
}

void readRays(PassBuilder& pass, const SceneHandles& scene, PipelineKind kind) {
    if (!scene.accelerationStructure) return;
    pass.read(*scene.accelerationStructure,
              kind == PipelineKind::Compute ? Access::ComputeRayQuery : Access::GraphicsRayQuery,
              shared::kBindingAccelerationStructure);
}

void readEmitters(PassBuilder& pass, const SceneHandles& scene, PipelineKind kind) {
    const Access texel = kind == PipelineKind::Compute ? Access::ComputeTexelRead : Access::GraphicsTexelRead;
    pass.read(scene.emitters, texel, shared::kBindingEmitters)
        .read(scene.emitterChoices, texel, shared::kBindingEmitterChoices)
        .read(scene.environmentTexels, texel, shared::kBindingEnvironmentTexels)
        .read(scene.environmentCells, texel, shared::kBindingEnvironmentCells);
}

}  // namespace manylight
