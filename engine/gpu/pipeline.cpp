#include "engine/gpu/pipeline.h"

#include "engine/core/check.h"
#include "engine/gpu/graphics_state.h"
#include "engine/gpu/pipeline_cache.h"
#include "engine/gpu/shader.h"

namespace manylight::gpu {
namespace {

/// VkSpecializationInfo for constants 0..n-1 and those of the tuning; the arrays live as long as this object.
struct SpecialisationInfo {
    Specialisation values;
    std::vector<VkSpecializationMapEntry> entries;
    VkSpecializationInfo info{};

    SpecialisationInfo(const Specialisation& ofPass, const TraversalTuning& traversal, uint32_t groupWidth = 1,
                       uint32_t groupHeight = 1)
        : values(ofPass) {
        MANYLIGHT_CHECK(values.size() <= size_t{shared::kConstantGroupWidth}, "specialisation");
        for (uint32_t i = 0; i < values.size(); ++i)
            if (values[i] != kAsInShader) addEntry(i, i);
        const auto add = [&](int constant, uint32_t value) {
            addEntry(static_cast<uint32_t>(constant), static_cast<uint32_t>(values.size()));
            values.push_back(value);
        };
        add(shared::kConstantGroupWidth, groupWidth);
        add(shared::kConstantGroupHeight, groupHeight);
        add(shared::kConstantStackInRegisters, traversal.stackInRegisters);
        add(shared::kConstantNodesAnyHit, traversal.nodesAnyHit);
        add(shared::kConstantNodesClosestHit, traversal.nodesClosestHit);
        add(shared::kConstantClosestInRegisters, traversal.closestInRegisters);
        info = {static_cast<uint32_t>(entries.size()), entries.data(), values.size() * sizeof(uint32_t), values.data()};
    }
    SpecialisationInfo(const SpecialisationInfo&) = delete;
    SpecialisationInfo& operator=(const SpecialisationInfo&) = delete;

  private:
    void addEntry(uint32_t constant, uint32_t place) {
        entries.push_back({constant, place * static_cast<uint32_t>(sizeof(uint32_t)), sizeof(uint32_t)});
    }
};

VkPipelineShaderStageCreateInfo stageInfo(VkShaderStageFlagBits stage, VkShaderModule module,
                                          const SpecialisationInfo& specialisation) {
    VkPipelineShaderStageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage = stage;
    info.module = module;
    info.pName = "main";
    info.pSpecializationInfo = &specialisation.info;
    return info;
}

}  // namespace

PipelineLibrary::PipelineLibrary(Device& device) : device_(device), cache_(loadPipelineCache(device)) {}

PipelineLibrary::~PipelineLibrary() {
    storePipelineCache(device_, cache_);
    for (const auto& [key, pipeline] : compute_) vkDestroyPipeline(device_.handle(), pipeline.handle, nullptr);
    for (const auto& [key, pipeline] : graphics_) vkDestroyPipeline(device_.handle(), pipeline.handle, nullptr);
    for (const auto& [name, module] : modules_) vkDestroyShaderModule(device_.handle(), module, nullptr);
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

Pipeline PipelineLibrary::makeCompute(const ComputeKey& key) {
    const SpecialisationInfo specialisation(key.specialisation, key.traversal, key.groupWidth, key.groupHeight);
    VkPipelineShaderStageRequiredSubgroupSizeCreateInfo subgroup{};
    subgroup.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_REQUIRED_SUBGROUP_SIZE_CREATE_INFO;
    subgroup.requiredSubgroupSize = device_.subgroupSize();

    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage = stageInfo(VK_SHADER_STAGE_COMPUTE_BIT, moduleFor(key.shader), specialisation);
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
    const SpecialisationInfo specialisation(key.specialisation, key.traversal);
    std::vector<VkPipelineShaderStageCreateInfo> stages = {
        stageInfo(VK_SHADER_STAGE_VERTEX_BIT, moduleFor(key.vertexShader), specialisation)};
    if (!key.fragmentShader.empty())
        stages.push_back(stageInfo(VK_SHADER_STAGE_FRAGMENT_BIT, moduleFor(key.fragmentShader), specialisation));

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

VkShaderModule PipelineLibrary::moduleFor(const std::string& shader) {
    const std::lock_guard lock(mutex_);
    VkShaderModule& module = modules_[shader];
    if (module != VK_NULL_HANDLE) return module;
    module = makeModule(shader, shaderCode(shader));
    return module;
}

VkShaderModule PipelineLibrary::makeModule(const std::string& shader, std::span<const uint32_t> words) {
    VkShaderModuleCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = words.size_bytes();
    info.pCode = words.data();
    VkShaderModule module = VK_NULL_HANDLE;
    check(vkCreateShaderModule(device_.handle(), &info, nullptr, &module), "loading " + shader);
    return module;
}

void PipelineLibrary::replaceShader(const std::string& shader, const std::vector<uint32_t>& words) {
    const VkShaderModule module = makeModule(shader, words);
    const std::lock_guard lock(mutex_);
    VkShaderModule& current = modules_[shader];
    if (current != VK_NULL_HANDLE) vkDestroyShaderModule(device_.handle(), current, nullptr);
    current = module;
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
