#include "engine/gpu/acceleration_structure.h"

#include "engine/gpu/memory_barrier.h"
#include "engine/gpu/transfer.h"

#include <algorithm>
#include <cstring>

namespace manylight::gpu {
namespace {

constexpr VkDeviceSize kCornerBytes = 16;

struct Limits {
    VkDeviceSize scratchAlignment = 1;
    uint64_t mostInstances = 0;
};

Limits limitsOf(const Device& device) {
    VkPhysicalDeviceAccelerationStructurePropertiesKHR structures{};
    structures.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &structures;
    vkGetPhysicalDeviceProperties2(device.physicalDevice(), &properties);
    return {std::max<VkDeviceSize>(structures.minAccelerationStructureScratchOffsetAlignment, 1),
            structures.maxInstanceCount};
}

/// One structure with its only geometry, to be built.
struct Build {
    VkAccelerationStructureGeometryKHR geometry{};
    VkAccelerationStructureTypeKHR type = VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR;
    uint32_t primitiveCount = 0;
    VkDeviceSize structureBytes = 0;
    VkDeviceSize scratchBytes = 0;

    VkAccelerationStructureBuildGeometryInfoKHR info() const {
        VkAccelerationStructureBuildGeometryInfoKHR info{};
        info.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_GEOMETRY_INFO_KHR;
        info.type = type;
        info.flags = VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_TRACE_BIT_KHR;
        info.mode = VK_BUILD_ACCELERATION_STRUCTURE_MODE_BUILD_KHR;
        info.geometryCount = 1;
        info.pGeometries = &geometry;
        return info;
    }

    void measure(const Device& device) {
        const VkAccelerationStructureBuildGeometryInfoKHR build = info();
        VkAccelerationStructureBuildSizesInfoKHR sizes{};
        sizes.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_SIZES_INFO_KHR;
        vkGetAccelerationStructureBuildSizesKHR(device.handle(), VK_ACCELERATION_STRUCTURE_BUILD_TYPE_DEVICE_KHR,
                                                &build, &primitiveCount, &sizes);
        structureBytes = sizes.accelerationStructureSize;
        scratchBytes = sizes.buildScratchSize;
    }
};

Buffer structureBuffer(Device& device, const std::string& name, const Build& build) {
    constexpr VkBufferUsageFlags kUsage =
        VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_STORAGE_BIT_KHR | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;
    return {device,
            name,
            {.size = build.structureBytes, .usage = kUsage, .memory = MemoryKind::Device, .structure = build.type}};
}

/// One after the other, for they share the scratch buffer. `targets` without a buffer are passed over.
void recordBuilds(Device& device, const std::vector<Build>& builds, const std::vector<Buffer>& targets) {
    const VkDeviceSize alignment = limitsOf(device).scratchAlignment;
    VkDeviceSize scratchBytes = 0;
    for (const Build& build : builds) scratchBytes = std::max(scratchBytes, build.scratchBytes);
    const Buffer scratch(device, "scratch of acceleration structures",
                         {.size = scratchBytes + alignment,
                          .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT});
    const VkDeviceAddress scratchAddress = (addressOf(device, scratch) + alignment - 1) / alignment * alignment;

    constexpr VkPipelineStageFlags2 kBuild = VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR;
    constexpr VkAccessFlags2 kWritten = VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR;
    constexpr VkAccessFlags2 kRead = VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR;
    submitAndWait(device, "building acceleration structures", [&](VkCommandBuffer commands) {
        recordMemoryBarrier(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT, kBuild,
                            VK_ACCESS_2_SHADER_READ_BIT | kRead | kWritten);
        for (size_t i = 0; i < builds.size(); ++i) {
            if (!targets[i].exists()) continue;
            VkAccelerationStructureBuildGeometryInfoKHR info = builds[i].info();
            info.dstAccelerationStructure = targets[i].structure();
            info.scratchData.deviceAddress = scratchAddress;
            const VkAccelerationStructureBuildRangeInfoKHR range{builds[i].primitiveCount, 0, 0, 0};
            const VkAccelerationStructureBuildRangeInfoKHR* const ranges = &range;
            vkCmdBuildAccelerationStructuresKHR(commands, 1, &info, &ranges);
            recordMemoryBarrier(commands, kBuild, kWritten, kBuild, kRead | kWritten);
        }
        recordMemoryBarrier(commands, kBuild, kWritten, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, kRead);
    });
}

Build describeTriangles(VkDeviceAddress corners, const TriangleRange& range) {
    Build build;
    build.primitiveCount = range.count;
    build.geometry.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR;
    build.geometry.geometryType = VK_GEOMETRY_TYPE_TRIANGLES_KHR;
    build.geometry.flags = range.isOpaque ? VK_GEOMETRY_OPAQUE_BIT_KHR : 0;
    VkAccelerationStructureGeometryTrianglesDataKHR& triangles = build.geometry.geometry.triangles;
    triangles.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_TRIANGLES_DATA_KHR;
    triangles.vertexFormat = VK_FORMAT_R32G32B32_SFLOAT;
    triangles.vertexData.deviceAddress = corners + 3 * kCornerBytes * range.first;
    triangles.vertexStride = kCornerBytes;
    triangles.maxVertex = 3 * range.count - 1;
    triangles.indexType = VK_INDEX_TYPE_NONE_KHR;
    return build;
}

VkTransformMatrixKHR transformOf(const StructureInstance& instance) {
    VkTransformMatrixKHR transform{};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) transform.matrix[row][column] = instance.sceneFromMesh[column][row];
        transform.matrix[row][3] = instance.center[row];
    }
    return transform;
}

/// Of a structure without triangles: zero, an instance that no ray meets.
VkDeviceAddress addressOfStructure(const Device& device, const Buffer& structure) {
    if (!structure.exists()) return 0;
    VkAccelerationStructureDeviceAddressInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_DEVICE_ADDRESS_INFO_KHR;
    info.accelerationStructure = structure.structure();
    return vkGetAccelerationStructureDeviceAddressKHR(device.handle(), &info);
}

}  // namespace

std::vector<Buffer> buildBottomLevels(Device& device, const Buffer& corners, std::span<const TriangleRange> ranges) {
    const VkDeviceAddress address = addressOf(device, corners);
    std::vector<Build> builds;
    std::vector<Buffer> structures;
    for (const TriangleRange& range : ranges) {
        builds.emplace_back();
        structures.emplace_back();
        if (range.count == 0) continue;
        builds.back() = describeTriangles(address, range);
        builds.back().measure(device);
        structures.back() = structureBuffer(device, "acceleration structure of a mesh", builds.back());
    }
    recordBuilds(device, builds, structures);
    return structures;
}

Buffer buildTopLevel(Device& device, std::span<const StructureInstance> instances) {
    if (const uint64_t most = limitsOf(device).mostInstances; instances.size() > most)
        fail("the scene has {} instances, device {} traces rays through {}: --rays software does without it",
             instances.size(), device.info().name, most);
    std::vector<VkAccelerationStructureInstanceKHR> records;
    for (const StructureInstance& instance : instances) {
        VkAccelerationStructureInstanceKHR record{};
        record.transform = transformOf(instance);
        record.mask = 0xff;
        record.flags = VK_GEOMETRY_INSTANCE_TRIANGLE_FACING_CULL_DISABLE_BIT_KHR;
        record.accelerationStructureReference = addressOfStructure(device, *instance.mesh);
        records.push_back(record);
    }
    const VkDeviceSize bytes = records.size() * sizeof(VkAccelerationStructureInstanceKHR);
    const Buffer input(device, "instances of acceleration structures",
                       {.size = bytes, .usage = kUsageOfStructureInput, .memory = MemoryKind::Upload});
    std::memcpy(input.mapped(), records.data(), bytes);

    std::vector<Build> builds(1);
    Build& build = builds[0];
    build.type = VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR;
    build.primitiveCount = static_cast<uint32_t>(records.size());
    build.geometry.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR;
    build.geometry.geometryType = VK_GEOMETRY_TYPE_INSTANCES_KHR;
    VkAccelerationStructureGeometryInstancesDataKHR& data = build.geometry.geometry.instances;
    data.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_INSTANCES_DATA_KHR;
    data.data.deviceAddress = addressOf(device, input);
    build.measure(device);
    std::vector<Buffer> structures;
    structures.push_back(structureBuffer(device, "acceleration structure", build));
    recordBuilds(device, builds, structures);
    return std::move(structures[0]);
}

}  // namespace manylight::gpu
