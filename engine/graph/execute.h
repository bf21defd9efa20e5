// Runs a frame graph: physical resources, one command buffer, barriers, labels and timers.
#pragma once

#include "engine/graph/breadcrumbs.h"
#include "engine/graph/compile.h"
#include "engine/graph/gpu_timers.h"
#include "engine/graph/pass_context.h"

#include <chrono>
#include <limits>
#include <memory>

namespace manylight {

struct PassTime {
    std::string pass;
    double milliseconds = 0.0;
};

/// An image that a pass wrote, copied right after that pass: see GraphExecutor::dumpAfter().
struct DumpedImage {
    std::string pass;
    std::string resource;
    VkFormat format = VK_FORMAT_UNDEFINED;
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<std::byte> bytes;
};

struct Execution {
    std::vector<PassTime> passTimes;  // GPU time of every live pass, in order
    double gpuMilliseconds = 0.0;     // from the first pass's start to the last one's end
    double wallMilliseconds = 0.0;    // submit to fence
    std::vector<DumpedImage> dumped;
};

class GraphExecutor {
  public:
    GraphExecutor(gpu::Device& device, gpu::PipelineLibrary& pipelines);
    ~GraphExecutor();
    GraphExecutor(const GraphExecutor&) = delete;
    GraphExecutor& operator=(const GraphExecutor&) = delete;

    /// Compiles, records, submits and waits. Pipelines not made yet are compiled first, on all cores. Names the pass
    /// that ran last if the device is lost.
    Execution execute(const FrameGraph& graph);

    /// execute() in two halves, for frames in flight: one executor each. What the graph imports must live until
    /// finish(). Semaphores may be null.
    void submit(const FrameGraph& graph, VkSemaphore waitFor = VK_NULL_HANDLE, VkSemaphore signal = VK_NULL_HANDLE);
    /// Waits for what was submitted; nothing to wait for gives an empty Execution.
    Execution finish();

    /// The images written by every pass whose name starts with `pass` will be in Execution::dumped. Empty: none;
    /// kAllPasses: those of all passes.
    void dumpAfter(std::string pass) { dumpAfter_ = std::move(pass); }
    static constexpr const char* kAllPasses = "*";

    /// Of the frames submitted from now on; the default until then. The device must be able to run it: see gpu::fits().
    void setTuning(const gpu::Tuning& tuning) { tuning_ = tuning; }
    const gpu::Tuning& tuning() const { return tuning_; }
    /// Of the trees that rays go through, in nodes on the longest way down, from now on; until then any.
    void setTreeDepth(uint32_t depth) { treeDepth_ = depth; }

    uint64_t transientBytes() const;

  private:
    std::vector<void*> placeResources(const FrameGraph& graph, const CompiledGraph& compiled);
    void* placeSlot(const PhysicalSlot& slot, const std::string& name);
    void compilePipelines(const FrameGraph& graph, const CompiledGraph& compiled, const std::vector<void*>& physical);
    void recordPass(const FrameGraph& graph, const LivePass& live, const std::vector<void*>& physical);
    void recordDump(const FrameGraph& graph, const Pass& pass, const std::vector<void*>& physical);
    void storeStates(const FrameGraph& graph, const CompiledGraph& compiled, const std::vector<void*>& physical);
    gpu::Tuning tuningOfFrame() const;
    void submitCommands(VkSemaphore waitFor, VkSemaphore signal);
    void wait();
    void dropUnused();
    bool isDumped(const Pass& pass) const;
    std::vector<DumpedImage> collectDumps();

    /// A pooled resource and whether this frame has taken it.
    template <typename Physical>
    struct Pooled {
        std::unique_ptr<Physical> physical;
        bool isTaken = false;
        uint32_t idleFrames = 0;
    };
    struct PendingDump {
        DumpedImage image;
        gpu::Buffer target;
    };

    gpu::Device& device_;
    gpu::PipelineLibrary& pipelines_;
    gpu::Tuning tuning_;
    uint32_t treeDepth_ = std::numeric_limits<uint32_t>::max();
    GpuTimers timers_;
    Breadcrumbs breadcrumbs_;
    VkCommandPool commandPool_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    VkFence fence_ = VK_NULL_HANDLE;
    std::vector<Pooled<PhysicalImage>> images_;
    std::vector<Pooled<PhysicalBuffer>> buffers_;
    std::string dumpAfter_;
    std::vector<PendingDump> pendingDumps_;
    std::vector<std::string> submitted_;  // names of the passes of the frame that runs
    bool isRunning_ = false;
    std::chrono::steady_clock::time_point start_;
};

}  // namespace manylight
