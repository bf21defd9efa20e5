#include "engine/gpu/graphics_state.h"

namespace manylight::gpu {

GraphicsState::GraphicsState(const GraphicsKey& key) : colorFormats_(key.colorFormats) {
    setVertexInput(key);
    viewport_.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    viewport_.viewportCount = 1;
    viewport_.scissorCount = 1;
    raster_.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    raster_.cullMode = VK_CULL_MODE_NONE;  // every surface reflects on both sides
    raster_.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
    raster_.lineWidth = 1.0f;
    multisample_.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    multisample_.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    setDepth(key);
    setTargets(key);
    dynamic_.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
    dynamic_.dynamicStateCount = static_cast<uint32_t>(dynamicStates_.size());
    dynamic_.pDynamicStates = dynamicStates_.data();
}

void GraphicsState::setVertexInput(const GraphicsKey& key) {
    vertexInput_.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    vertexInput_.vertexBindingDescriptionCount = key.triangleRecords ? 1 : 0;
    vertexInput_.pVertexBindingDescriptions = &corner_;
    vertexInput_.vertexAttributeDescriptionCount = key.triangleRecords ? 1 : 0;
    vertexInput_.pVertexAttributeDescriptions = &position_;
    assembly_.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    assembly_.topology = key.topology;
}

void GraphicsState::setDepth(const GraphicsKey& key) {
    depth_.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
    depth_.depthTestEnable = key.depthFormat != VK_FORMAT_UNDEFINED;
    depth_.depthWriteEnable = key.depthWrite;
    depth_.depthCompareOp = key.depthCompare;
}

void GraphicsState::setTargets(const GraphicsKey& key) {
    VkPipelineColorBlendAttachmentState target{};
    target.colorWriteMask =
        VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    target.blendEnable = key.additiveBlend || key.overBlend;
    target.srcColorBlendFactor = target.dstColorBlendFactor = VK_BLEND_FACTOR_ONE;
    target.srcAlphaBlendFactor = target.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
    if (key.overBlend) {
        target.srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
        target.dstColorBlendFactor = target.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
    }
    targets_.assign(key.colorFormats.size(), target);
    blend_.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blend_.attachmentCount = static_cast<uint32_t>(targets_.size());
    blend_.pAttachments = targets_.data();
    rendering_.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
    rendering_.colorAttachmentCount = static_cast<uint32_t>(colorFormats_.size());
    rendering_.pColorAttachmentFormats = colorFormats_.data();
    rendering_.depthAttachmentFormat = key.depthFormat;
}

VkGraphicsPipelineCreateInfo GraphicsState::createInfo() const {
    VkGraphicsPipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    info.pNext = &rendering_;
    info.pVertexInputState = &vertexInput_;
    info.pInputAssemblyState = &assembly_;
    info.pViewportState = &viewport_;
    info.pRasterizationState = &raster_;
    info.pMultisampleState = &multisample_;
    info.pDepthStencilState = &depth_;
    info.pColorBlendState = &blend_;
    info.pDynamicState = &dynamic_;
    return info;
}

}  // namespace manylight::gpu
