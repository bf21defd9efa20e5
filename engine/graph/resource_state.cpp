#include "engine/graph/resource_state.h"

#include <algorithm>

namespace manylight {

namespace {

bool covers(const SyncScope& outer, const SyncScope& inner) {
    return (outer.stages & inner.stages) == inner.stages && (outer.access & inner.access) == inner.access;
}

// Scopes are compared one by one: merged, compute-uniform and fragment-storage would claim compute-storage too.
bool isVisible(const ResourceState& state, const SyncScope& reader) {
    return state.lastWrite.stages == 0 || std::any_of(state.visibleTo.begin(), state.visibleTo.end(),
                                                      [&](const SyncScope& scope) { return covers(scope, reader); });
}

}  // namespace

ResourceState unknownState() {
    return {.lastWrite = everythingBefore(), .visibleTo = {}, .readers = 0, .layout = VK_IMAGE_LAYOUT_UNDEFINED};
}

std::optional<Dependency> advance(ResourceState& state, Access access, ResourceKind kind) {
    const AccessInfo& info = accessInfo(access);
    const SyncScope scope = readScope(info);
    const VkImageLayout layout = kind == ResourceKind::Image ? info.imageLayout : VK_IMAGE_LAYOUT_UNDEFINED;
    const bool changesLayout = layout != state.layout;
    const bool overwrites = info.writes || changesLayout;

    // An overwrite waits for the readers if there are any: they waited for the write, whose memory is available by
    // then. Otherwise it waits for the write itself, and so does a read that cannot see it yet.
    const bool waitsForReaders = overwrites && state.readers != 0;
    const SyncScope before = waitsForReaders ? SyncScope{state.readers, 0} : state.lastWrite;
    const bool mustWait = overwrites ? before.stages != 0 : !isVisible(state, scope);
    std::optional<Dependency> dependency;
    if (mustWait || changesLayout) dependency = Dependency{before, scope, state.layout, layout};

    // Advance. After a layout change, later readers must chain to the barrier that made it (whose second scope this
    // is), not to the shader that wrote the content; what it wrote is available already.
    if (info.writes) {
        state = {.lastWrite = writeScope(info), .visibleTo = {}, .readers = 0, .layout = layout};
    } else if (changesLayout) {
        state = {.lastWrite = {info.stages, 0}, .visibleTo = {scope}, .readers = info.stages, .layout = layout};
    } else {
        if (mustWait) state.visibleTo.push_back(scope);
        state.readers |= info.stages;
    }
    return dependency;
}

}  // namespace manylight
