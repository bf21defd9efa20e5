#include "engine/graph/compile.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace manylight {

namespace {

// Backwards: a pass lives if it is kept or if one of its versions is needed; then what it builds on is needed too.
void cull(const FrameGraph& graph, CompiledGraph& compiled) {
    const auto& resources = graph.resources();
    std::vector<std::vector<bool>> needed;
    for (const Resource& resource : resources) {
        needed.emplace_back(resource.version + 1, false);
        needed.back().back() = resource.kept;
    }
    for (uint32_t p = static_cast<uint32_t>(graph.passes().size()); p-- > 0;) {
        const Pass& pass = graph.passes()[p];
        const bool lives =
            !pass.keepReason.empty() || std::any_of(pass.uses.begin(), pass.uses.end(), [&](const PassUse& use) {
                return use.writes() && needed[use.resource][use.versionAfter];
            });
        if (!lives) {
            compiled.culled.push_back(p);
            continue;
        }
        compiled.passes.push_back({.pass = p, .barriers = {}});
        for (const PassUse& use : pass.uses) {
            if (use.needsContent) needed[use.resource][use.versionBefore] = true;
        }
    }
    std::reverse(compiled.passes.begin(), compiled.passes.end());
    std::reverse(compiled.culled.begin(), compiled.culled.end());
}

void deriveLifetimesAndUsage(const FrameGraph& graph, CompiledGraph& compiled) {
    compiled.resources.resize(graph.resources().size());
    for (uint32_t live = 0; live < compiled.passes.size(); ++live) {
        for (const PassUse& use : graph.passes()[compiled.passes[live].pass].uses) {
            CompiledResource& resource = compiled.resources[use.resource];
            const bool isImage = graph.resources()[use.resource].kind == ResourceKind::Image;
            const AccessInfo& info = accessInfo(use.access);
            resource.imageUsage |= isImage ? info.imageUsage : 0;
            resource.bufferUsage |= isImage ? 0 : info.bufferUsage;
            if (resource.firstPass == kNoIndex) resource.firstPass = live;
            const bool kept = graph.resources()[use.resource].kept;
            resource.lastPass = kept ? static_cast<uint32_t>(compiled.passes.size() - 1) : live;
        }
    }
}

bool canTake(const PhysicalSlot& slot, const Resource& resource, uint32_t firstPass) {
    return slot.kind == resource.kind && slot.image == resource.image && slot.buffer == resource.buffer &&
           slot.lastPass < firstPass;
}

void assignSlots(const FrameGraph& graph, CompiledGraph& compiled) {
    std::vector<uint32_t> byFirstPass(compiled.resources.size());
    std::iota(byFirstPass.begin(), byFirstPass.end(), 0u);
    std::stable_sort(byFirstPass.begin(), byFirstPass.end(), [&](uint32_t a, uint32_t b) {
        return compiled.resources[a].firstPass < compiled.resources[b].firstPass;
    });
    for (const uint32_t r : byFirstPass) {
        const Resource& declared = graph.resources()[r];
        CompiledResource& resource = compiled.resources[r];
        if (declared.imported || resource.firstPass == kNoIndex) continue;
        auto slot = std::find_if(compiled.slots.begin(), compiled.slots.end(), [&](const PhysicalSlot& candidate) {
            return canTake(candidate, declared, resource.firstPass);
        });
        if (slot == compiled.slots.end()) {
            slot = compiled.slots.insert(
                slot, {.kind = declared.kind, .image = declared.image, .buffer = declared.buffer, .finalState = {}});
        }
        slot->imageUsage |= resource.imageUsage;
        slot->bufferUsage |= resource.bufferUsage;
        slot->lastPass = resource.lastPass;
        resource.slot = static_cast<uint32_t>(slot - compiled.slots.begin());
    }
}

// A slot starts from what its last owner left, which may be in a frame that is still running: frames follow each
// other on one queue, so a barrier is enough and no fence is needed. That frame may have had another graph, so the
// state comes from whoever holds the physical resources; unless they say, everything submitted before is waited for.
void startStates(const FrameGraph& graph, const FrameGraph::SlotStates& slotStates, CompiledGraph& compiled) {
    for (PhysicalSlot& slot : compiled.slots) slot.finalState = slotStates ? slotStates(slot) : unknownState();
    for (size_t r = 0; r < compiled.resources.size(); ++r) {
        compiled.resources[r].finalState = graph.resources()[r].initial;
    }
}

void deriveBarriers(const FrameGraph& graph, CompiledGraph& compiled) {
    for (uint32_t live = 0; live < compiled.passes.size(); ++live) {
        LivePass& pass = compiled.passes[live];
        for (const PassUse& use : graph.passes()[pass.pass].uses) {
            CompiledResource& resource = compiled.resources[use.resource];
            const bool ownsSlot = resource.slot != kNoIndex;
            ResourceState& state = ownsSlot ? compiled.slots[resource.slot].finalState : resource.finalState;
            // A new owner waits for the last one but does not want its content.
            if (ownsSlot && resource.firstPass == live) state.layout = VK_IMAGE_LAYOUT_UNDEFINED;
            const auto dependency = advance(state, use.access, graph.resources()[use.resource].kind);
            if (dependency) pass.barriers.push_back({use.resource, *dependency});
        }
    }
}

}  // namespace

CompiledGraph FrameGraph::compile(const SlotStates& slotStates) const {
    CompiledGraph compiled;
    // 1. Which passes live: backwards from what is kept.
    cull(*this, compiled);
    // 2. How long each resource lives and what it is used for, by live passes only.
    deriveLifetimesAndUsage(*this, compiled);
    // 3. Which transients share a physical slot: equal descriptions, disjoint lifetimes.
    assignSlots(*this, compiled);
    // 4. The state each physical resource comes with.
    startStates(*this, slotStates, compiled);
    // 5. Which barriers stand before each pass; afterwards the states are the final ones.
    deriveBarriers(*this, compiled);
    return compiled;
}

}  // namespace manylight
