#include "engine/graph/execute.h"

#include "engine/core/check.h"
#include "engine/graph/record_barriers.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace manylight {
namespace {

void beginLabel(VkCommandBuffer commands, const std::string& name) {
    if (vkCmdBeginDebugUtilsLabelEXT == nullptr) return;
    VkDebugUtilsLabelEXT label{};
    label.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT;
    label.pLabelName = name.c_str();
    vkCmdBeginDebugUtilsLabelEXT(commands, &label);
}

void endLabel(VkCommandBuffer commands) {
    if (vkCmdEndDebugUtilsLabelEXT != nullptr) vkCmdEndDebugUtilsLabelEXT(commands);
}

/// Runs all tasks on as many threads as the machine has; rethrows the first exception.
void runInParallel(const std::vector<std::function<void()>>& tasks) {
    std::atomic<size_t> next = 0;
    std::exception_ptr failure;
    std::mutex failureMutex;
    const auto work = [&] {
        for (size_t task = next++; task < tasks.size(); task = next++) try {
                tasks[task]();
            } catch (...) {
                const std::lock_guard lock(failureMutex);
                failure = std::current_exception();
            }
    };
    std::vector<std::thread> threads;
    const size_t count = std::min<size_t>(tasks.size(), std::max(1u, std::thread::hardware_concurrency()));
    for (size_t i = 1; i < count; ++i) threads.emplace_back(work);
    work();
    for (std::thread& thread : threads) thread.join();
    if (failure) std::rethrow_exception(failure);
}

constexpr uint32_t kMostIdleFrames = 64;

bool hasAttachments(const Pass& pass) {
    return std::any_of(pass.uses.begin(), pass.uses.end(),
                       [](const PassUse& use) { return isAttachment(accessInfo(use.access)); });
}

}  // namespace

GraphExecutor::GraphExecutor(gpu::Device& device, gpu::PipelineLibrary& pipelines)
    : device_(device), pipelines_(pipelines), timers_(device), breadcrumbs_(device) {
    VkCommandPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool.queueFamilyIndex = device.queueFamily();
    gpu::check(vkCreateCommandPool(device.handle(), &pool, nullptr, &commandPool_), "creating a command pool");
    VkCommandBufferAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocate.commandPool = commandPool_;
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    gpu::check(vkAllocateCommandBuffers(device.handle(), &allocate, &commands_), "allocating a command buffer");
    VkFenceCreateInfo fence{};
    fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    gpu::check(vkCreateFence(device.handle(), &fence, nullptr, &fence_), "creating a fence");
}

GraphExecutor::~GraphExecutor() {
    vkDeviceWaitIdle(device_.handle());
    vkDestroyFence(device_.handle(), fence_, nullptr);
    vkDestroyCommandPool(device_.handle(), commandPool_, nullptr);
}

Execution GraphExecutor::execute(const FrameGraph& graph) {
    submit(graph);
    return finish();
}

void GraphExecutor::submit(const FrameGraph& graph, VkSemaphore waitFor, VkSemaphore signal) {
    MANYLIGHT_CHECK(!isRunning_, "submit() while a frame of this executor runs");
    // 1. Compile. One frame runs at a time, so a slot's past is over when the next frame starts.
    const CompiledGraph compiled = graph.compile([](const PhysicalSlot&) { return ResourceState{}; });
    const std::vector<void*> physical = placeResources(graph, compiled);
    compilePipelines(graph, compiled, physical);

    // 2. Record.
    gpu::check(vkResetCommandPool(device_.handle(), commandPool_, 0), "resetting commands");
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    gpu::check(vkBeginCommandBuffer(commands_, &begin), "recording a frame");
    timers_.reset(static_cast<uint32_t>(compiled.passes.size()));
    breadcrumbs_.reset(static_cast<uint32_t>(compiled.passes.size()));
    submitted_.clear();
    for (uint32_t i = 0; i < compiled.passes.size(); ++i) {
        breadcrumbs_.drop(commands_, i);
        timers_.begin(commands_, i);
        recordPass(graph, compiled.passes[i], physical);
        timers_.end(commands_, i);
        const Pass& pass = graph.passes()[compiled.passes[i].pass];
        if (isDumped(pass)) recordDump(graph, pass, physical);
        submitted_.push_back(pass.name);
    }
    gpu::check(vkEndCommandBuffer(commands_), "recording a frame");

    // 3. Run. Frames follow each other on one queue: what this one leaves is the next one's start.
    submitCommands(waitFor, signal);
    storeStates(graph, compiled, physical);
}

Execution GraphExecutor::finish() {
    if (!isRunning_) return {};
    wait();
    Execution execution;
    execution.wallMilliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    const std::vector<GpuTimers::Interval> intervals = timers_.read();
    for (size_t i = 0; i < intervals.size(); ++i)
        execution.passTimes.push_back({submitted_[i], intervals[i].end - intervals[i].begin});
    if (!intervals.empty()) execution.gpuMilliseconds = intervals.back().end;
    execution.dumped = collectDumps();
    dropUnused();
    return execution;
}

std::vector<void*> GraphExecutor::placeResources(const FrameGraph& graph, const CompiledGraph& compiled) {
    for (auto& image : images_) image.isTaken = false;
    for (auto& buffer : buffers_) buffer.isTaken = false;
    std::vector<void*> slots;
    for (uint32_t slot = 0; slot < compiled.slots.size(); ++slot) {
        const auto owner = std::find_if(compiled.resources.begin(), compiled.resources.end(),
                                        [&](const auto& resource) { return resource.slot == slot; });
        const auto index = static_cast<size_t>(owner - compiled.resources.begin());
        slots.push_back(placeSlot(compiled.slots[slot], graph.resources()[index].name));
    }
    std::vector<void*> physical;
    for (size_t i = 0; i < graph.resources().size(); ++i) {
        const Resource& resource = graph.resources()[i];
        const uint32_t slot = compiled.resources[i].slot;
        physical.push_back(resource.imported ? resource.external : slot != kNoIndex ? slots[slot] : nullptr);
    }
    return physical;
}

void* GraphExecutor::placeSlot(const PhysicalSlot& slot, const std::string& name) {
    if (slot.kind == ResourceKind::Image) {
        const VkImageUsageFlags usage = slot.imageUsage | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;  // for dumpAfter()
        for (auto& image : images_) {
            const gpu::TextureInfo& info = image.physical->texture.info();
            if (image.isTaken || info.format != slot.image.format || info.width != slot.image.width ||
                info.height != slot.image.height || (info.usage & usage) != usage)
                continue;
            image.isTaken = true;
            return image.physical.get();
        }
        auto made = std::make_unique<PhysicalImage>();
        made->texture = gpu::Texture(device_, name, {slot.image.format, slot.image.width, slot.image.height, usage});
        images_.push_back({std::move(made), true, 0});
        return images_.back().physical.get();
    }
    for (auto& buffer : buffers_) {
        const gpu::BufferInfo& info = buffer.physical->buffer.info();
        if (buffer.isTaken || info.size != std::max<VkDeviceSize>(slot.buffer.size, 16) ||
            info.texelFormat != slot.buffer.texelFormat || (info.usage & slot.bufferUsage) != slot.bufferUsage)
            continue;
        buffer.isTaken = true;
        return buffer.physical.get();
    }
    auto made = std::make_unique<PhysicalBuffer>();
    made->buffer = gpu::Buffer(device_, name,
                               {slot.buffer.size, slot.bufferUsage, gpu::MemoryKind::Device, slot.buffer.texelFormat});
    buffers_.push_back({std::move(made), true, 0});
    return buffers_.back().physical.get();
}

gpu::Tuning GraphExecutor::tuningOfFrame() const {
    gpu::Tuning tuning = tuning_;
    tuning.traversal = gpu::forTreesOfDepth(tuning.traversal, treeDepth_);
    return tuning;
}

void GraphExecutor::compilePipelines(const FrameGraph& graph, const CompiledGraph& compiled,
                                     const std::vector<void*>& physical) {
    const gpu::Tuning tuning = tuningOfFrame();
    PipelineKeys keys;
    for (const LivePass& live : compiled.passes) {
        const Pass& pass = graph.passes()[live.pass];
        PassContext context(graph, pass, pipelines_, tuning, physical, VK_NULL_HANDLE, &keys);
        if (pass.execute) pass.execute(context);
    }
    std::vector<std::function<void()>> tasks;
    for (const gpu::ComputeKey& key : keys.compute)
        if (!pipelines_.has(key)) tasks.emplace_back([&] { pipelines_.compute(key); });
    for (const gpu::GraphicsKey& key : keys.graphics)
        if (!pipelines_.has(key)) tasks.emplace_back([&] { pipelines_.graphics(key); });
    runInParallel(tasks);
}

void GraphExecutor::recordPass(const FrameGraph& graph, const LivePass& live, const std::vector<void*>& physical) {
    const Pass& pass = graph.passes()[live.pass];
    beginLabel(commands_, pass.name);
    BarrierRecorder barriers;
    for (const Barrier& barrier : live.barriers) {
        if (graph.resources()[barrier.resource].kind == ResourceKind::Image)
            barriers.add(static_cast<PhysicalImage*>(physical[barrier.resource])->texture, barrier.dependency);
        else
            barriers.add(static_cast<PhysicalBuffer*>(physical[barrier.resource])->buffer, barrier.dependency);
    }
    barriers.record(commands_);

    const gpu::Tuning tuning = tuningOfFrame();
    PassContext context(graph, pass, pipelines_, tuning, physical, commands_, nullptr);
    if (hasAttachments(pass)) {
        context.beginRendering();
        pass.execute(context);
        vkCmdEndRendering(commands_);
    } else if (pass.execute) {
        pass.execute(context);
    }
    endLabel(commands_);
}

void GraphExecutor::recordDump(const FrameGraph& graph, const Pass& pass, const std::vector<void*>& physical) {
    for (const PassUse& use : pass.uses) {
        const Resource& resource = graph.resources()[use.resource];
        if (resource.kind != ResourceKind::Image || !use.writes()) continue;
        const gpu::Texture& texture = static_cast<PhysicalImage*>(physical[use.resource])->texture;
        const VkDeviceSize size =
            VkDeviceSize{resource.image.width} * resource.image.height * gpu::texelBytes(resource.image.format);
        PendingDump dump{
            {pass.name, resource.name, resource.image.format, resource.image.width, resource.image.height, {}},
            gpu::Buffer(device_, "dump of " + resource.name,
                        {size, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::MemoryKind::Readback})};

        // A debugging aid: wait for everything, copy, and put the layout back as the next pass expects it.
        ResourceState state = unknownState();
        const VkImageLayout layout = accessInfo(use.access).imageLayout;
        Dependency toCopy = *advance(state, Access::TransferRead, ResourceKind::Image);
        toCopy.oldLayout = layout;
        BarrierRecorder before;
        before.add(texture, toCopy);
        before.record(commands_);
        VkBufferImageCopy region{};
        region.imageSubresource = {texture.aspect(), 0, 0, 1};
        region.imageExtent = {resource.image.width, resource.image.height, 1};
        vkCmdCopyImageToBuffer(commands_, texture.handle(), accessInfo(Access::TransferRead).imageLayout,
                               dump.target.handle(), 1, &region);
        BarrierRecorder after;
        after.add(texture, Dependency{toCopy.after, toCopy.before, toCopy.newLayout, layout});
        ResourceState copied;
        advance(copied, Access::TransferWrite, ResourceKind::Buffer);
        after.add(dump.target, advance(copied, Access::HostRead, ResourceKind::Buffer));
        after.record(commands_);
        pendingDumps_.push_back(std::move(dump));
    }
}

std::vector<DumpedImage> GraphExecutor::collectDumps() {
    std::vector<DumpedImage> dumps;
    for (PendingDump& dump : pendingDumps_) {
        dump.image.bytes.resize(dump.target.size());
        std::memcpy(dump.image.bytes.data(), dump.target.mapped(), dump.image.bytes.size());
        dumps.push_back(std::move(dump.image));
    }
    pendingDumps_.clear();
    return dumps;
}

void GraphExecutor::storeStates(const FrameGraph& graph, const CompiledGraph& compiled,
                                const std::vector<void*>& physical) {
    for (size_t i = 0; i < graph.resources().size(); ++i) {
        const Resource& resource = graph.resources()[i];
        if (!resource.imported || compiled.resources[i].firstPass == kNoIndex) continue;
        const ResourceState& state = compiled.resources[i].finalState;
        if (resource.kind == ResourceKind::Image)
            static_cast<PhysicalImage*>(physical[i])->state = state;
        else
            static_cast<PhysicalBuffer*>(physical[i])->state = state;
    }
}

bool GraphExecutor::isDumped(const Pass& pass) const {
    return dumpAfter_ == kAllPasses || (!dumpAfter_.empty() && pass.name.starts_with(dumpAfter_));
}

void GraphExecutor::submitCommands(VkSemaphore waitFor, VkSemaphore signal) {
    start_ = std::chrono::steady_clock::now();
    VkCommandBufferSubmitInfo commands{};
    commands.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
    commands.commandBuffer = commands_;
    VkSemaphoreSubmitInfo before{};
    before.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO;
    before.semaphore = waitFor;
    before.stageMask = everythingBefore().stages;
    VkSemaphoreSubmitInfo after = before;
    after.semaphore = signal;
    VkSubmitInfo2 submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
    submit.waitSemaphoreInfoCount = waitFor != VK_NULL_HANDLE ? 1 : 0;
    submit.pWaitSemaphoreInfos = &before;
    submit.commandBufferInfoCount = 1;
    submit.pCommandBufferInfos = &commands;
    submit.signalSemaphoreInfoCount = signal != VK_NULL_HANDLE ? 1 : 0;
    submit.pSignalSemaphoreInfos = &after;
    gpu::check(vkQueueSubmit2(device_.queue(), 1, &submit, fence_), "submitting a frame");
    isRunning_ = true;
}

void GraphExecutor::wait() {
    isRunning_ = false;
    const VkResult result = vkWaitForFences(device_.handle(), 1, &fence_, VK_TRUE, UINT64_MAX);
    if (result < VK_SUCCESS) {
        const uint32_t started = breadcrumbs_.startedCount();
        gpu::check(result, started == 0 ? std::string("running a frame, before its first pass")
                                        : fmt::format("running a frame, in pass {} ({} of {})", submitted_[started - 1],
                                                      started, submitted_.size()));
    }
    gpu::check(vkResetFences(device_.handle(), 1, &fence_), "running a frame");
}

// Pictures that change their size leave resources that nothing takes any more.
void GraphExecutor::dropUnused() {
    const auto drop = [](auto& pool) {
        for (auto& pooled : pool) pooled.idleFrames = pooled.isTaken ? 0 : pooled.idleFrames + 1;
        std::erase_if(pool, [](const auto& pooled) { return pooled.idleFrames > kMostIdleFrames; });
    };
    drop(images_);
    drop(buffers_);
}

uint64_t GraphExecutor::transientBytes() const {
    uint64_t bytes = 0;
    for (const auto& image : images_) {
        const gpu::TextureInfo& info = image.physical->texture.info();
        bytes += uint64_t{info.width} * info.height * gpu::texelBytes(info.format);
    }
    for (const auto& buffer : buffers_) bytes += buffer.physical->buffer.size();
    return bytes;
}

}  // namespace manylight
