#include "engine/gpu/pipeline.h"

#include "engine/core/check.h"
#include "engine/gpu/graphics_state.h"
#include "engine/gpu/pipeline_cache.h"
#include "engine/gpu/shader.h"
#include "engine/gpu/specialise.h"

#include <optional>

namespace manylight::gpu {
namespace {

/// Value i for constant_id i, and those of the tuning.
ConstantValues constantValues(const Specialisation& ofPass, const TraversalTuning& traversal, uint32_t groupWidth = 1,
                              uint32_t groupHeight = 1) {
    MANYLIGHT_CHECK(ofPass.size() <= size_t{shared::kConstantGroupWidth}, "specialisation");
    ConstantValues values = {{shared::kConstantGroupWidth, groupWidth},
                             {shared::kConstantGroupHeight, groupHeight},
                             {shared::kConstantStackInRegisters, traversal.stackInRegisters},
                             {shared::kConstantNodesAnyHit, traversal.nodesAnyHit},
                             {shared::kConstantNodesClosestHit, traversal.nodesClosestHit},
                             {shared::kConstantClosestRegisters, traversal.closestRegisters}};
    for (uint32_t i = 0; i < ofPass.size(); ++i)
        if (ofPass[i] != kAsInShader) values[i] = ofPass[i];
    return values;
}

VkPipelineShaderStageCreateInfo stageInfo(VkShaderStageFlagBits stage, VkShaderModule module) {
    VkPipelineShaderStageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage = stage;
    info.module = module;
    info.pName = "main";
    return info;
}

}  // namespace

PipelineLibrary::PipelineLibrary(Device& device) : device_(device), cache_(loadPipelineCache(device)) {}

PipelineLibrary::~PipelineLibrary() {
    storePipelineCache(device_, cache_);
    for (const auto& [key, pipeline] : compute_) vkDestroyPipeline(device_.handle(), pipeline.handle, nullptr);
    for (const auto& [key, pipeline] : graphics_) vkDestroyPipeline(device_.handle(), pipeline.handle, nullptr);
    for (const auto& [bindings, layout] : layouts_) {
        vkDestroyPipelineLayout(device_.handle(), layout.pipeline, nullptr);
        vkDestroyDescriptorSetLayout(device_.handle(), layout.set, nullptr);
    }
    vkDestroyPipelineCache(device_.handle(), cache_, nullptr);
}

Pipeline PipelineLibrary::compute(const ComputeKey& key) {
    {
        const std::lock_guard lock(mutex_);
        if (const auto found = compute_.find(key); found != compute_.end()) return found->second;
    }
    const Pipeline made = makeCompute(key);
    const std::lock_guard lock(mutex_);
    const auto [entry, isNew] = compute_.emplace(key, made);
    if (!isNew) vkDestroyPipeline(device_.handle(), made.handle, nullptr);
    return entry->second;
}

Pipeline PipelineLibrary::graphics(const GraphicsKey& key) {
    {
        const std::lock_guard lock(mutex_);
        if (const auto found = graphics_.find(key); found != graphics_.end()) return found->second;
    }
    const Pipeline made = makeGraphics(key);
    const std::lock_guard lock(mutex_);
    const auto [entry, isNew] = graphics_.emplace(key, made);
    if (!isNew) vkDestroyPipeline(device_.handle(), made.handle, nullptr);
    return entry->second;
}

bool PipelineLibrary::has(const ComputeKey& key) {
    const std::lock_guard lock(mutex_);
    return compute_.contains(key);
}

bool PipelineLibrary::has(const GraphicsKey& key) {
    const std::lock_guard lock(mutex_);
    return graphics_.contains(key);
}

/// One pipeline's shader, gone once the pipeline is made.
struct PipelineLibrary::Module {
    Device& device;
    VkShaderModule handle = VK_NULL_HANDLE;

    Module(Device& onDevice, const std::string& shader, std::span<const uint32_t> words) : device(onDevice) {
        VkShaderModuleCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
        info.codeSize = words.size_bytes();
        info.pCode = words.data();
        check(vkCreateShaderModule(device.handle(), &info, nullptr, &handle), "loading " + shader);
    }
    Module(PipelineLibrary& library, const std::string& shader, const ConstantValues& values)
        : Module(library.device_, shader, specialised(library.codeOf(shader), values)) {}
    ~Module() { vkDestroyShaderModule(device.handle(), handle, nullptr); }
    Module(const Module&) = delete;
    Module& operator=(const Module&) = delete;
};

std::vector<uint32_t> PipelineLibrary::codeOf(const std::string& shader) {
    const std::lock_guard lock(mutex_);
    if (const auto found = replaced_.find(shader); found != replaced_.end()) return found->second;
    const std::span<const uint32_t> words = shaderCode(shader);
    return {words.begin(), words.end()};
}

Pipeline PipelineLibrary::makeCompute(const ComputeKey& key) {
    const Module module(*this, key.shader,
                        constantValues(key.specialisation, key.traversal, key.groupWidth, key.groupHeight));
    VkPipelineShaderStageRequiredSubgroupSizeCreateInfo subgroup{};
    subgroup.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_REQUIRED_SUBGROUP_SIZE_CREATE_INFO;
    subgroup.requiredSubgroupSize = device_.subgroupSize();

    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage = stageInfo(VK_SHADER_STAGE_COMPUTE_BIT, module.handle);
    if (key.fullSubgroups) {
        info.stage.flags = VK_PIPELINE_SHADER_STAGE_CREATE_REQUIRE_FULL_SUBGROUPS_BIT;
        if (device_.canRequireSubgroupSize()) info.stage.pNext = &subgroup;
    }
    info.layout = layoutFor(key.bindings);
    Pipeline pipeline{VK_NULL_HANDLE, info.layout};
    check(vkCreateComputePipelines(device_.handle(), cache_, 1, &info, nullptr, &pipeline.handle),
          "compiling " + key.shader);
    device_.setName(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<uint64_t>(pipeline.handle), key.shader);
    return pipeline;
}

Pipeline PipelineLibrary::makeGraphics(const GraphicsKey& key) {
    const ConstantValues values = constantValues(key.specialisation, key.traversal);
    const Module vertex(*this, key.vertexShader, values);
    std::vector<VkPipelineShaderStageCreateInfo> stages = {stageInfo(VK_SHADER_STAGE_VERTEX_BIT, vertex.handle)};
    std::optional<Module> fragment;
    if (!key.fragmentShader.empty()) {
        fragment.emplace(*this, key.fragmentShader, values);
        stages.push_back(stageInfo(VK_SHADER_STAGE_FRAGMENT_BIT, fragment->handle));
    }

    const GraphicsState state(key);
    VkGraphicsPipelineCreateInfo info = state.createInfo();
    info.stageCount = static_cast<uint32_t>(stages.size());
    info.pStages = stages.data();
    info.layout = layoutFor(key.bindings);
    Pipeline pipeline{VK_NULL_HANDLE, info.layout};
    const std::string name = key.fragmentShader.empty() ? key.vertexShader : key.fragmentShader;
    check(vkCreateGraphicsPipelines(device_.handle(), cache_, 1, &info, nullptr, &pipeline.handle),
          "compiling " + name);
    device_.setName(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<uint64_t>(pipeline.handle), name);
    return pipeline;
}

VkPipelineLayout PipelineLibrary::layoutFor(const std::vector<BindingLayout>& bindings) {
    const std::lock_guard lock(mutex_);
    Layout& layout = layouts_[bindings];
    if (layout.pipeline != VK_NULL_HANDLE) return layout.pipeline;

    std::vector<VkDescriptorSetLayoutBinding> setBindings;
    for (const BindingLayout& binding : bindings)
        setBindings.push_back({binding.binding, binding.type, 1, VK_SHADER_STAGE_ALL, nullptr});
    VkDescriptorSetLayoutCreateInfo setInfo{};
    setInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    setInfo.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR;
    setInfo.bindingCount = static_cast<uint32_t>(setBindings.size());
    setInfo.pBindings = setBindings.data();
    check(vkCreateDescriptorSetLayout(device_.handle(), &setInfo, nullptr, &layout.set), "creating a set layout");

    const VkPushConstantRange push{VK_SHADER_STAGE_ALL, 0, kPushConstantBytes};
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = 1;
    info.pSetLayouts = &layout.set;
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &push;
    check(vkCreatePipelineLayout(device_.handle(), &info, nullptr, &layout.pipeline), "creating a pipeline layout");
    return layout.pipeline;
}

size_t PipelineLibrary::differenceFrom(const PipelineLibrary& other) const {
    const auto missing = [](const auto& from, const auto& in) {
        return std::ranges::count_if(from, [&](const auto& entry) { return !in.contains(entry.first); });
    };
    return static_cast<size_t>(missing(compute_, other.compute_) + missing(other.compute_, compute_) +
                               missing(graphics_, other.graphics_) + missing(other.graphics_, graphics_));
}

void PipelineLibrary::replaceShader(const std::string& shader, const std::vector<uint32_t>& words) {
    {
        const Module accepted(device_, shader, words);
    }
    const std::lock_guard lock(mutex_);
    replaced_[shader] = words;
    const auto forget = [&](auto& pipelines, const auto& uses) {
        std::erase_if(pipelines, [&](const auto& entry) {
            if (!uses(entry.first)) return false;
            vkDestroyPipeline(device_.handle(), entry.second.handle, nullptr);
            return true;
        });
    };
    forget(compute_, [&](const ComputeKey& key) { return key.shader == shader; });
    forget(graphics_,
           [&](const GraphicsKey& key) { return key.vertexShader == shader || key.fragmentShader == shader; });
}

}  // namespace manylight::gpu
