// What a physical resource has been through, and the barrier its next access needs.
#pragma once

#include "engine/graph/access.h"

#include <optional>
#include <vector>

namespace manylight {

/// Lives on the physical resource, from frame to frame. Default: never used, nothing to wait for.
struct ResourceState {
    SyncScope lastWrite;                ///< a layout change counts as a write
    std::vector<SyncScope> visibleTo;   ///< scopes that a barrier has already shown the last write to
    VkPipelineStageFlags2 readers = 0;  ///< stages that read since the last write; each of them waited for it
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;

    bool operator==(const ResourceState&) const = default;
};

/// The state of a resource whose past is unknown: the next access waits for everything submitted before it.
ResourceState unknownState();

/// One memory barrier, less the resource. Buffers have both layouts undefined.
struct Dependency {
    SyncScope before;
    SyncScope after;
    VkImageLayout oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    VkImageLayout newLayout = VK_IMAGE_LAYOUT_UNDEFINED;

    bool operator==(const Dependency&) const = default;
};

enum class ResourceKind : uint8_t { Image, Buffer };

/// The barrier that has to stand before `access`, if any; `state` becomes the state after that access.
std::optional<Dependency> advance(ResourceState& state, Access access, ResourceKind kind);

}  // namespace manylight
