// The frame graph: passes declare what they touch; everything else follows from that. Built anew each frame.
// Declaration order is execution order. Misuse throws BugError naming the pass and the resource.
#pragma once

#include "engine/graph/resource_state.h"

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace manylight {

class PassBuilder;
class PassContext;
struct CompiledGraph;
struct PhysicalSlot;

inline constexpr uint32_t kNoIndex = std::numeric_limits<uint32_t>::max();
inline constexpr uint32_t kNoBinding = kNoIndex;

/// One version of a resource's content. Each write returns the next version and makes the earlier handles stale.
template <ResourceKind kind>
struct Handle {
    uint32_t resource = kNoIndex;
    uint32_t version = 0;

    bool operator==(const Handle&) const = default;
};
using ImageHandle = Handle<ResourceKind::Image>;
using BufferHandle = Handle<ResourceKind::Buffer>;

struct ImageDesc {
    VkFormat format = VK_FORMAT_UNDEFINED;
    uint32_t width = 0;   // pixels
    uint32_t height = 0;  // pixels

    bool operator==(const ImageDesc&) const = default;
};

struct BufferDesc {
    VkDeviceSize size = 0;                       // bytes
    VkFormat texelFormat = VK_FORMAT_UNDEFINED;  // needed by texel reads

    bool operator==(const BufferDesc&) const = default;
};

/// A declared image or buffer.
struct Resource {
    std::string name;
    ResourceKind kind = ResourceKind::Image;
    ImageDesc image = {};    // of an image
    BufferDesc buffer = {};  // of a buffer
    bool imported = false;
    void* external = nullptr;    // the importer's own object, handed through untouched
    ResourceState initial = {};  // of an imported resource
    bool hasContent = false;     // something was written, here or before this frame
    uint32_t version = 0;        // current
    bool kept = false;
};

/// One access of a pass. A read has `versionAfter == versionBefore`.
struct PassUse {
    uint32_t resource = kNoIndex;
    uint32_t versionBefore = 0;
    uint32_t versionAfter = 0;
    Access access = Access::ComputeStorageRead;
    uint32_t binding = kNoBinding;
    std::optional<VkClearValue> clear = {};
    bool needsContent = true;  // depends on versionBefore; false for a pure write and a cleared attachment

    bool writes() const { return versionAfter != versionBefore; }
};

struct Pass {
    std::string name;
    std::vector<PassUse> uses;  // in the order declared; color attachments take their locations from it
    std::string keepReason;     // empty: the pass lives only if its results are needed
    std::function<void(PassContext&)> execute;
};

class FrameGraph {
  public:
    /// Transient: lives in this frame only, in memory shared with others.
    ImageHandle createImage(std::string name, const ImageDesc& desc);
    BufferHandle createBuffer(std::string name, const BufferDesc& desc);
    /// Outlives the frame. `initial` is its state so far; an image in the undefined layout has no content.
    ImageHandle importImage(std::string name, const ImageDesc& desc, ResourceState initial, void* external);
    BufferHandle importBuffer(std::string name, const BufferDesc& desc, ResourceState initial, void* external);
    PassBuilder addPass(std::string name);
    /// A result of the frame. Culling goes backwards from these; nothing may overwrite one afterwards.
    template <ResourceKind kind>
    void keep(Handle<kind> handle) {
        keepResult(kind, handle.resource, handle.version);
    }

    /// Gives the state in which a physical slot was left by its last owner. Asked once per slot.
    using SlotStates = std::function<ResourceState(const PhysicalSlot&)>;
    /// See compile.h. Without `slotStates` every slot's first use waits for all that was submitted before.
    CompiledGraph compile(const SlotStates& slotStates = {}) const;

    const std::vector<Resource>& resources() const { return resources_; }
    const std::vector<Pass>& passes() const { return passes_; }

  private:
    friend class PassBuilder;
    uint32_t addResource(Resource resource);
    Resource& current(const std::string& user, ResourceKind kind, uint32_t resource, uint32_t version);
    void keepResult(ResourceKind kind, uint32_t resource, uint32_t version);
    uint32_t addUse(uint32_t pass, ResourceKind kind, PassUse use, bool isWrite);

    std::vector<Resource> resources_;
    std::vector<Pass> passes_;
};

/// Declares the accesses of the pass added last; not to be used once the next one is added.
class PassBuilder {
  public:
    template <ResourceKind kind>
    PassBuilder& read(Handle<kind> handle, Access access, uint32_t binding = kNoBinding) {
        graph_.addUse(pass_, kind, {handle.resource, handle.version, handle.version, access, binding}, false);
        return *this;
    }
    /// An attachment is loaded here, so it must have content. Returns the handle of what the pass leaves.
    template <ResourceKind kind>
    Handle<kind> write(Handle<kind> handle, Access access, uint32_t binding = kNoBinding) {
        const PassUse use{handle.resource, handle.version, handle.version, access, binding};
        return {handle.resource, graph_.addUse(pass_, kind, use, true)};
    }
    /// An attachment that is cleared first.
    ImageHandle write(ImageHandle image, Access access, const VkClearValue& clear) {
        const PassUse use{image.resource, image.version, image.version, access, kNoBinding, clear};
        return {image.resource, graph_.addUse(pass_, ResourceKind::Image, use, true)};
    }
    /// The pass lives although nobody needs its results; `reason` names its hidden effect.
    PassBuilder& keep(std::string reason);
    void execute(std::function<void(PassContext&)> record) { graph_.passes_[pass_].execute = std::move(record); }

  private:
    friend class FrameGraph;
    PassBuilder(FrameGraph& graph, uint32_t pass) : graph_(graph), pass_(pass) {}

    FrameGraph& graph_;
    uint32_t pass_;
};

}  // namespace manylight
