// What a pass's execute function works with: dispatches and draws. Bindings, attachments, formats and blending follow
// from what the pass declared.
#pragma once

#include "engine/gpu/pipeline.h"
#include "engine/graph/physical.h"

#include <cstring>
#include <set>
#include <span>

namespace manylight {

/// A compute entry point with its choices made.
struct ComputeKernel {
    const char* shader = nullptr;  // "vpl_light.comp"
    gpu::Workgroup group = {};
    gpu::Specialisation specialisation = {};
    bool fullSubgroups = false;  // the shader shuffles
};

/// A vertex and a fragment entry point with their choices made.
struct DrawKernel {
    const char* vertexShader = nullptr;
    const char* fragmentShader = "";  // empty: depth only
    gpu::Specialisation specialisation = {};
    VkCompareOp depthCompare = VK_COMPARE_OP_LESS;
    bool overBlend = false;  // ColorBlend puts fragments over what is there, by their alpha, instead of adding them
};

/// Vertices [first, first + count), once for each instance of [firstInstance, firstInstance + instanceCount).
struct DrawRange {
    uint32_t first = 0;
    uint32_t count = 0;
    uint32_t firstInstance = 0;
    uint32_t instanceCount = 1;
};

/// Pipelines that a frame will need, collected before recording so that they can be compiled side by side.
struct PipelineKeys {
    std::set<gpu::ComputeKey> compute;
    std::set<gpu::GraphicsKey> graphics;
};

class PassContext {
  public:
    /// What suits the device: sizes of workgroups, for the most part.
    const gpu::Tuning& tuning() const { return tuning_; }
    /// Runs `width` * `height` threads, rounded up to whole groups.
    template <typename Push>
    void dispatch(const ComputeKernel& kernel, uint32_t width, uint32_t height, const Push& push) {
        static_assert(sizeof(Push) <= gpu::kPushConstantBytes);
        dispatchBytes(kernel, width, height, &push, sizeof(Push));
    }
    void dispatch(const ComputeKernel& kernel, uint32_t width, uint32_t height = 1) {
        dispatchBytes(kernel, width, height, nullptr, 0);
    }
    /// Draws one range after the other; from the pass's vertex buffer if it declared one.
    template <typename Push>
    void draw(const DrawKernel& kernel, std::span<const DrawRange> ranges, const Push& push) {
        static_assert(sizeof(Push) <= gpu::kPushConstantBytes);
        drawBytes(kernel, ranges, &push, sizeof(Push));
    }
    void draw(const DrawKernel& kernel, std::span<const DrawRange> ranges) { drawBytes(kernel, ranges, nullptr, 0); }
    /// Draws the first `vertexCount` vertices.
    template <typename Push>
    void draw(const DrawKernel& kernel, uint32_t vertexCount, const Push& push) {
        const DrawRange range{.count = vertexCount};
        draw(kernel, std::span(&range, 1), push);
    }
    void draw(const DrawKernel& kernel, uint32_t vertexCount) {
        const DrawRange range{.count = vertexCount};
        draw(kernel, std::span(&range, 1));
    }
    /// Fills a buffer the pass writes by TransferWrite.
    void fill(BufferHandle buffer, uint32_t word);
    /// Copies bytes [offset, offset + size) of `source` (TransferRead) to the start of `target` (TransferWrite).
    void copy(BufferHandle source, VkDeviceSize offset, VkDeviceSize size, BufferHandle target);

  private:
    friend class GraphExecutor;
    struct Attachments;

    PassContext(const FrameGraph& graph, const Pass& pass, gpu::PipelineLibrary& pipelines, const gpu::Tuning& tuning,
                const std::vector<void*>& physical, VkCommandBuffer commands, PipelineKeys* collected)
        : graph_(graph),
          pass_(pass),
          pipelines_(pipelines),
          tuning_(tuning),
          physical_(physical),
          commands_(commands),
          collected_(collected) {}

    void dispatchBytes(const ComputeKernel& kernel, uint32_t width, uint32_t height, const void* push, size_t bytes);
    void drawBytes(const DrawKernel& kernel, std::span<const DrawRange> ranges, const void* push, size_t bytes);
    std::string variantOf(const char* shader) const;
    gpu::ComputeKey keyOf(const ComputeKernel& kernel) const;
    gpu::GraphicsKey keyOf(const DrawKernel& kernel) const;
    std::vector<gpu::BindingLayout> bindings() const;
    void bind(VkPipelineBindPoint point, const gpu::Pipeline& pipeline, const void* push, size_t bytes) const;
    void beginRendering() const;

    PhysicalImage& image(uint32_t resource) const { return *static_cast<PhysicalImage*>(physical_[resource]); }
    PhysicalBuffer& buffer(uint32_t resource) const { return *static_cast<PhysicalBuffer*>(physical_[resource]); }

    const FrameGraph& graph_;
    const Pass& pass_;
    gpu::PipelineLibrary& pipelines_;
    const gpu::Tuning& tuning_;
    const std::vector<void*>& physical_;  // PhysicalImage or PhysicalBuffer per resource
    VkCommandBuffer commands_;
    PipelineKeys* collected_;  // non-null: only note which pipelines are needed, record nothing
};

}  // namespace manylight
