// The fixed-function state of a graphics pipeline, from its description.
#pragma once

#include "engine/gpu/pipeline.h"

#include <array>
#include <vector>

namespace manylight::gpu {

/// Holds the structs that a VkGraphicsPipelineCreateInfo points to.
class GraphicsState {
  public:
    explicit GraphicsState(const GraphicsKey& key);
    GraphicsState(const GraphicsState&) = delete;
    GraphicsState& operator=(const GraphicsState&) = delete;

    /// Everything but stages and layout. Valid as long as this object.
    VkGraphicsPipelineCreateInfo createInfo() const;

  private:
    void setVertexInput(const GraphicsKey& key);
    void setDepth(const GraphicsKey& key);
    void setTargets(const GraphicsKey& key);

    VkVertexInputBindingDescription corner_{0, 16, VK_VERTEX_INPUT_RATE_VERTEX};
    VkVertexInputAttributeDescription position_{0, 0, VK_FORMAT_R32G32B32_SFLOAT, 0};
    VkPipelineVertexInputStateCreateInfo vertexInput_{};
    VkPipelineInputAssemblyStateCreateInfo assembly_{};
    VkPipelineViewportStateCreateInfo viewport_{};
    VkPipelineRasterizationStateCreateInfo raster_{};
    VkPipelineMultisampleStateCreateInfo multisample_{};
    VkPipelineDepthStencilStateCreateInfo depth_{};
    std::vector<VkPipelineColorBlendAttachmentState> targets_;
    VkPipelineColorBlendStateCreateInfo blend_{};
    std::array<VkDynamicState, 2> dynamicStates_{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    VkPipelineDynamicStateCreateInfo dynamic_{};
    std::vector<VkFormat> colorFormats_;
    VkPipelineRenderingCreateInfo rendering_{};
};

}  // namespace manylight::gpu
