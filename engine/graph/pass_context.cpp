#include "engine/graph/pass_context.h"

#include "engine/core/check.h"
#include "engine/gpu/shader.h"

#include <algorithm>

namespace manylight {
namespace {

VkDescriptorType descriptorOf(const Resource& resource, const PassUse& use) {
    const AccessInfo& info = accessInfo(use.access);
    return resource.kind == ResourceKind::Image ? info.imageDescriptor : info.bufferDescriptor;
}

bool isVertexBuffer(const PassUse& use) {
    return use.access == Access::VertexBuffer || use.access == Access::VertexAndTexels;
}

uint32_t groupsFor(uint32_t threads, uint32_t groupSize) { return (threads + groupSize - 1) / groupSize; }

}  // namespace

std::vector<gpu::BindingLayout> PassContext::bindings() const {
    std::vector<gpu::BindingLayout> layouts;
    for (const PassUse& use : pass_.uses)
        if (use.binding != kNoBinding)
            layouts.push_back({use.binding, descriptorOf(graph_.resources()[use.resource], use)});
    std::sort(layouts.begin(), layouts.end());
    return layouts;
}

std::string PassContext::variantOf(const char* shader) const {
    const bool queriesRays = std::any_of(pass_.uses.begin(), pass_.uses.end(), [](const PassUse& use) {
        return use.access == Access::ComputeRayQuery || use.access == Access::GraphicsRayQuery;
    });
    return queriesRays ? gpu::rayQueryVariant(shader) : shader;
}

gpu::ComputeKey PassContext::keyOf(const ComputeKernel& kernel) const {
    const gpu::Workgroup& group = kernel.group;
    return {variantOf(kernel.shader),
            kernel.specialisation,
            bindings(),
            kernel.fullSubgroups,
            group.isTile ? group.width * group.height : group.width,
            group.isTile ? 1 : group.height,
            tuning_.traversal};
}

gpu::GraphicsKey PassContext::keyOf(const DrawKernel& kernel) const {
    gpu::GraphicsKey key;
    key.vertexShader = kernel.vertexShader;
    if (*kernel.fragmentShader != '\0') key.fragmentShader = variantOf(kernel.fragmentShader);
    key.specialisation = kernel.specialisation;
    key.bindings = bindings();
    key.traversal = tuning_.traversal;
    key.depthCompare = kernel.depthCompare;
    for (const PassUse& use : pass_.uses) {
        const VkFormat format = graph_.resources()[use.resource].image.format;
        if (use.access == Access::ColorWrite || use.access == Access::ColorBlend) key.colorFormats.push_back(format);
        if (use.access == Access::ColorBlend) (kernel.overBlend ? key.overBlend : key.additiveBlend) = true;
        if (use.access == Access::DepthWrite || use.access == Access::DepthRead) key.depthFormat = format;
        if (use.access == Access::DepthWrite) key.depthWrite = true;
        if (isVertexBuffer(use)) key.triangleRecords = true;
    }
    return key;
}

void PassContext::bind(VkPipelineBindPoint point, const gpu::Pipeline& pipeline, const void* push, size_t bytes) const {
    vkCmdBindPipeline(commands_, point, pipeline.handle);
    std::vector<VkDescriptorImageInfo> images(pass_.uses.size());
    std::vector<VkDescriptorBufferInfo> buffers(pass_.uses.size());
    std::vector<VkBufferView> views(pass_.uses.size());
    std::vector<VkWriteDescriptorSetAccelerationStructureKHR> structures(pass_.uses.size());
    std::vector<VkWriteDescriptorSet> writes;
    for (size_t i = 0; i < pass_.uses.size(); ++i) {
        const PassUse& use = pass_.uses[i];
        if (use.binding == kNoBinding) continue;
        const Resource& resource = graph_.resources()[use.resource];
        VkWriteDescriptorSet write{};
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstBinding = use.binding;
        write.descriptorCount = 1;
        write.descriptorType = descriptorOf(resource, use);
        if (resource.kind == ResourceKind::Image) {
            images[i] = {VK_NULL_HANDLE, image(use.resource).texture.view(), accessInfo(use.access).imageLayout};
            write.pImageInfo = &images[i];
        } else if (write.descriptorType == VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER) {
            views[i] = buffer(use.resource).buffer.texelView();
            write.pTexelBufferView = &views[i];
        } else if (write.descriptorType == VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR) {
            structures[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET_ACCELERATION_STRUCTURE_KHR;
            structures[i].accelerationStructureCount = 1;
            structures[i].pAccelerationStructures = &buffer(use.resource).buffer.structure();
            write.pNext = &structures[i];
        } else {
            buffers[i] = {buffer(use.resource).buffer.handle(), 0, VK_WHOLE_SIZE};
            write.pBufferInfo = &buffers[i];
        }
        writes.push_back(write);
    }
    if (!writes.empty())
        vkCmdPushDescriptorSetKHR(commands_, point, pipeline.layout, 0, static_cast<uint32_t>(writes.size()),
                                  writes.data());
    if (bytes > 0)
        vkCmdPushConstants(commands_, pipeline.layout, VK_SHADER_STAGE_ALL, 0, static_cast<uint32_t>(bytes), push);
}

void PassContext::dispatchBytes(const ComputeKernel& kernel, uint32_t width, uint32_t height, const void* push,
                                size_t bytes) {
    const gpu::ComputeKey key = keyOf(kernel);
    if (collected_ != nullptr) {
        collected_->compute.insert(key);
        return;
    }
    if (width == 0 || height == 0) return;
    bind(VK_PIPELINE_BIND_POINT_COMPUTE, pipelines_.compute(key), push, bytes);
    vkCmdDispatch(commands_, groupsFor(width, kernel.group.width), groupsFor(height, kernel.group.height), 1);
}

void PassContext::drawBytes(const DrawKernel& kernel, std::span<const DrawRange> ranges, const void* push,
                            size_t bytes) {
    const gpu::GraphicsKey key = keyOf(kernel);
    if (collected_ != nullptr) {
        collected_->graphics.insert(key);
        return;
    }
    bind(VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.graphics(key), push, bytes);
    for (const PassUse& use : pass_.uses) {
        if (!isVertexBuffer(use)) continue;
        const VkBuffer vertices = buffer(use.resource).buffer.handle();
        const VkDeviceSize offset = 0;
        vkCmdBindVertexBuffers(commands_, 0, 1, &vertices, &offset);
    }
    for (const DrawRange& range : ranges)
        if (range.count > 0) vkCmdDraw(commands_, range.count, range.instanceCount, range.first, range.firstInstance);
}

void PassContext::fill(BufferHandle target, uint32_t word) {
    if (collected_ != nullptr) return;
    vkCmdFillBuffer(commands_, buffer(target.resource).buffer.handle(), 0, VK_WHOLE_SIZE, word);
}

void PassContext::copy(BufferHandle source, VkDeviceSize offset, VkDeviceSize size, BufferHandle target) {
    MANYLIGHT_CHECK(size <= graph_.resources()[target.resource].buffer.size, "copy in pass {}", pass_.name);
    if (collected_ != nullptr) return;
    const VkBufferCopy region{offset, 0, size};
    vkCmdCopyBuffer(commands_, buffer(source.resource).buffer.handle(), buffer(target.resource).buffer.handle(), 1,
                    &region);
}

void PassContext::beginRendering() const {
    std::vector<VkRenderingAttachmentInfo> colors;
    VkRenderingAttachmentInfo depth{};
    VkExtent2D extent{};
    for (const PassUse& use : pass_.uses) {
        const AccessInfo& info = accessInfo(use.access);
        if (!isAttachment(info)) continue;
        const gpu::Texture& texture = image(use.resource).texture;
        extent = {texture.info().width, texture.info().height};
        VkRenderingAttachmentInfo attachment{};
        attachment.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
        attachment.imageView = texture.view();
        attachment.imageLayout = info.imageLayout;
        attachment.loadOp = use.clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
        attachment.storeOp = info.writes ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_NONE;
        if (use.clear) attachment.clearValue = *use.clear;
        if (gpu::isDepthFormat(texture.info().format))
            depth = attachment;
        else
            colors.push_back(attachment);
    }
    VkRenderingInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
    info.renderArea.extent = extent;
    info.layerCount = 1;
    info.colorAttachmentCount = static_cast<uint32_t>(colors.size());
    info.pColorAttachments = colors.data();
    info.pDepthAttachment = depth.imageView != VK_NULL_HANDLE ? &depth : nullptr;
    vkCmdBeginRendering(commands_, &info);
    const VkViewport viewport{0, 0, static_cast<float>(extent.width), static_cast<float>(extent.height), 0, 1};
    const VkRect2D scissor{{0, 0}, extent};
    vkCmdSetViewport(commands_, 0, 1, &viewport);
    vkCmdSetScissor(commands_, 0, 1, &scissor);
}

}  // namespace manylight
