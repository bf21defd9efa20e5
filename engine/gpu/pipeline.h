// Pipelines by description: made once, kept for the life of the device, with Vulkan's cache on disk.
#pragma once

#include "engine/gpu/device.h"
#include "engine/gpu/tuning.h"

#include <compare>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace manylight::gpu {

/// One binding of descriptor set 0, which is always pushed.
struct BindingLayout {
    uint32_t binding = 0;
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    auto operator<=>(const BindingLayout&) const = default;
};

/// Value i specialises constant_id i, unless it is kAsInShader; i is below those of shaders/shared/workgroups.h. Floats
/// go through std::bit_cast.
using Specialisation = std::vector<uint32_t>;
inline constexpr uint32_t kAsInShader = 0xfffffffeu;

struct ComputeKey {
    std::string shader;  // "vpl_light.comp"
    Specialisation specialisation;
    std::vector<BindingLayout> bindings;  // sorted by binding
    bool fullSubgroups = false;           // ask for full subgroups of Device::subgroupSize()
    uint32_t groupWidth = 1;              // threads along x, where the shader leaves it open: see workgroups.h
    uint32_t groupHeight = 1;             // along y
    TraversalTuning traversal;
    auto operator<=>(const ComputeKey&) const = default;
};

struct GraphicsKey {
    std::string vertexShader;
    std::string fragmentShader;  // empty: depth only
    Specialisation specialisation;
    std::vector<BindingLayout> bindings;
    std::vector<VkFormat> colorFormats;
    VkFormat depthFormat = VK_FORMAT_UNDEFINED;
    bool depthWrite = false;
    VkCompareOp depthCompare = VK_COMPARE_OP_LESS;
    bool additiveBlend = false;
    bool overBlend = false;  // by the fragment's alpha, over what is there; goes before additiveBlend
    VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    bool triangleRecords = false;  // location 0 is the position of a triangle record's corner, 16 bytes apart
    TraversalTuning traversal;
    auto operator<=>(const GraphicsKey&) const = default;
};

struct Pipeline {
    VkPipeline handle = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
};

/// Push constants: one range of this many bytes, for every stage of every pipeline.
inline constexpr uint32_t kPushConstantBytes = 128;

class PipelineLibrary {
  public:
    explicit PipelineLibrary(Device& device);
    /// Stores the cache on disk; a failure to do so is no error.
    ~PipelineLibrary();
    PipelineLibrary(const PipelineLibrary&) = delete;
    PipelineLibrary& operator=(const PipelineLibrary&) = delete;

    /// Thread-safe: several threads may ask for different pipelines at once.
    Pipeline compute(const ComputeKey& key);
    Pipeline graphics(const GraphicsKey& key);
    bool has(const ComputeKey& key);
    bool has(const GraphicsKey& key);
    /// Pipelines made from now on use `words` as this entry point, instead of what was compiled in. The device must be
    /// idle. If the driver refuses it, the Error comes before anything has changed.
    void replaceShader(const std::string& shader, const std::vector<uint32_t>& words);
    size_t size() const { return compute_.size() + graphics_.size(); }
    /// Of both together: those that one has and the other has not. No thread may be asking for pipelines meanwhile.
    size_t differenceFrom(const PipelineLibrary& other) const;

  private:
    Pipeline makeCompute(const ComputeKey& key);
    Pipeline makeGraphics(const GraphicsKey& key);
    VkPipelineLayout layoutFor(const std::vector<BindingLayout>& bindings);
    std::vector<uint32_t> codeOf(const std::string& shader);

    struct Module;
    struct Layout {
        VkDescriptorSetLayout set = VK_NULL_HANDLE;
        VkPipelineLayout pipeline = VK_NULL_HANDLE;
    };

    Device& device_;
    VkPipelineCache cache_ = VK_NULL_HANDLE;
    std::mutex mutex_;
    std::map<std::vector<BindingLayout>, Layout> layouts_;
    std::map<std::string, std::vector<uint32_t>> replaced_;
    std::map<ComputeKey, Pipeline> compute_;
    std::map<GraphicsKey, Pipeline> graphics_;
};

}  // namespace manylight::gpu
