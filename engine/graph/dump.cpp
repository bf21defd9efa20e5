#include "engine/graph/dump.h"

#include "engine/graph/flag_names.h"

#include <fmt/format.h>

#include <algorithm>

namespace manylight {

namespace {

/// The live pass that runs declared pass `pass`; null if it was culled.
const LivePass* findLive(const CompiledGraph& compiled, uint32_t pass) {
    const auto found = std::find_if(compiled.passes.begin(), compiled.passes.end(),
                                    [&](const LivePass& live) { return live.pass == pass; });
    return found == compiled.passes.end() ? nullptr : &*found;
}

std::string scopeText(const SyncScope& scope) {
    return scope.access == 0 ? stageNames(scope.stages)
                             : fmt::format("{}({})", stageNames(scope.stages), accessNames(scope.access));
}

std::string descText(ResourceKind kind, const ImageDesc& image, const BufferDesc& buffer) {
    if (kind == ResourceKind::Image) {
        return fmt::format("image {}x{} {}", image.width, image.height, formatName(image.format));
    }
    const bool hasTexels = buffer.texelFormat != VK_FORMAT_UNDEFINED;
    return fmt::format("buffer {} bytes{}", buffer.size, hasTexels ? " of " + formatName(buffer.texelFormat) : "");
}

std::string usageText(ResourceKind kind, VkImageUsageFlags image, VkBufferUsageFlags buffer) {
    return kind == ResourceKind::Image ? imageUsageNames(image) : bufferUsageNames(buffer);
}

std::string useText(const FrameGraph& graph, const PassUse& use) {
    std::string text = fmt::format("{} {}.{} {}", use.writes() ? "write" : "read", graph.resources()[use.resource].name,
                                   use.versionAfter, accessInfo(use.access).name);
    if (use.binding != kNoBinding) text += fmt::format(" binding {}", use.binding);
    if (use.clear) text += " cleared";
    return text;
}

std::string barrierText(const FrameGraph& graph, const Barrier& barrier) {
    const Dependency& dependency = barrier.dependency;
    std::string text = fmt::format("barrier {} {} -> {}", graph.resources()[barrier.resource].name,
                                   scopeText(dependency.before), scopeText(dependency.after));
    if (dependency.oldLayout != dependency.newLayout) {
        text += fmt::format(", {} -> {}", layoutName(dependency.oldLayout), layoutName(dependency.newLayout));
    }
    return text;
}

std::string quoted(const std::string& text) { return Json(text).dump(); }

Json barrierJson(const FrameGraph& graph, const Barrier& barrier) {
    const Dependency& dependency = barrier.dependency;
    return {{"resource", graph.resources()[barrier.resource].name}, {"srcStages", stageNames(dependency.before.stages)},
            {"srcAccess", accessNames(dependency.before.access)},   {"dstStages", stageNames(dependency.after.stages)},
            {"dstAccess", accessNames(dependency.after.access)},    {"oldLayout", layoutName(dependency.oldLayout)},
            {"newLayout", layoutName(dependency.newLayout)}};
}

Json passJson(const FrameGraph& graph, const Pass& pass, const LivePass* live) {
    Json uses = Json::array();
    for (const PassUse& use : pass.uses) {
        uses.push_back({{"resource", graph.resources()[use.resource].name},
                        {"access", accessInfo(use.access).name},
                        {"writes", use.writes()},
                        {"version", use.versionAfter},
                        {"cleared", use.clear.has_value()}});
        if (use.binding != kNoBinding) uses.back()["binding"] = use.binding;
    }
    Json barriers = Json::array();
    if (live != nullptr) {
        for (const Barrier& barrier : live->barriers) barriers.push_back(barrierJson(graph, barrier));
    }
    Json json = {{"name", pass.name}, {"culled", live == nullptr}, {"uses", uses}, {"barriers", barriers}};
    if (!pass.keepReason.empty()) json["kept"] = pass.keepReason;
    return json;
}

Json resourceJson(const Resource& resource, const CompiledResource& compiled) {
    Json json = {{"name", resource.name},
                 {"description", descText(resource.kind, resource.image, resource.buffer)},
                 {"imported", resource.imported},
                 {"kept", resource.kept},
                 {"used", compiled.firstPass != kNoIndex}};
    if (compiled.firstPass == kNoIndex) return json;
    json["usage"] = usageText(resource.kind, compiled.imageUsage, compiled.bufferUsage);
    json["firstLivePass"] = compiled.firstPass;
    json["lastLivePass"] = compiled.lastPass;
    if (compiled.slot != kNoIndex) json["slot"] = compiled.slot;
    return json;
}

std::string resourceText(const Resource& resource, const CompiledResource& compiled) {
    std::string text =
        fmt::format("resource {}: {}{}", resource.name, descText(resource.kind, resource.image, resource.buffer),
                    resource.imported ? ", imported" : "");
    if (resource.kept) text += ", kept";
    if (compiled.firstPass == kNoIndex) return text + ", unused";
    text += fmt::format(", live passes {}-{}, usage {}", compiled.firstPass, compiled.lastPass,
                        usageText(resource.kind, compiled.imageUsage, compiled.bufferUsage));
    return compiled.slot == kNoIndex ? text : text + fmt::format(", slot {}", compiled.slot);
}

}  // namespace

std::string toText(const FrameGraph& graph, const CompiledGraph& compiled) {
    std::string text;
    const auto line = [&](const std::string& content) { text.append(content).append("\n"); };
    for (uint32_t p = 0; p < graph.passes().size(); ++p) {
        const Pass& pass = graph.passes()[p];
        const LivePass* live = findLive(compiled, p);
        line(fmt::format("{} {}{}", live != nullptr ? "pass" : "culled", pass.name,
                         pass.keepReason.empty() ? "" : " (kept: " + pass.keepReason + ")"));
        if (live != nullptr) {
            for (const Barrier& barrier : live->barriers) line("    " + barrierText(graph, barrier));
        }
        for (const PassUse& use : pass.uses) line("    " + useText(graph, use));
    }
    for (size_t r = 0; r < compiled.resources.size(); ++r) {
        line(resourceText(graph.resources()[r], compiled.resources[r]));
    }
    for (size_t s = 0; s < compiled.slots.size(); ++s) {
        const PhysicalSlot& slot = compiled.slots[s];
        line(fmt::format("slot {}: {}, usage {}", s, descText(slot.kind, slot.image, slot.buffer),
                         usageText(slot.kind, slot.imageUsage, slot.bufferUsage)));
    }
    return text;
}

std::string toDot(const FrameGraph& graph, const CompiledGraph& compiled) {
    std::string dot = "digraph frame {\n    rankdir=LR;\n    node [fontname=\"sans-serif\"];\n";
    const auto line = [&](const std::string& content) { dot.append("    ").append(content).append(";\n"); };
    for (size_t r = 0; r < graph.resources().size(); ++r) {
        const Resource& resource = graph.resources()[r];
        for (uint32_t version = resource.imported ? 0 : 1; version <= resource.version; ++version) {
            line(fmt::format("r{}_{} [shape=ellipse, style={}, label={}]", r, version,
                             compiled.resources[r].firstPass == kNoIndex ? "dashed" : "solid",
                             quoted(fmt::format("{}.{}", resource.name, version))));
        }
    }
    for (uint32_t p = 0; p < graph.passes().size(); ++p) {
        const Pass& pass = graph.passes()[p];
        const LivePass* live = findLive(compiled, p);
        const size_t barriers = live != nullptr ? live->barriers.size() : 0;
        const std::string label = live == nullptr ? pass.name : fmt::format("{}\nbarriers: {}", pass.name, barriers);
        line(
            fmt::format("p{} [shape=box, style={}, label={}]", p, live == nullptr ? "dashed" : "solid", quoted(label)));
        for (const PassUse& use : pass.uses) {
            const std::string accessName = quoted(accessInfo(use.access).name);
            if (use.needsContent)
                line(fmt::format("r{}_{} -> p{} [label={}]", use.resource, use.versionBefore, p, accessName));
            if (use.writes())
                line(fmt::format("p{} -> r{}_{} [label={}]", p, use.resource, use.versionAfter, accessName));
        }
    }
    return dot + "}\n";
}

Json toJson(const FrameGraph& graph, const CompiledGraph& compiled) {
    Json passes = Json::array();
    for (uint32_t p = 0; p < graph.passes().size(); ++p) {
        passes.push_back(passJson(graph, graph.passes()[p], findLive(compiled, p)));
    }
    Json resources = Json::array();
    for (size_t r = 0; r < compiled.resources.size(); ++r) {
        resources.push_back(resourceJson(graph.resources()[r], compiled.resources[r]));
    }
    Json slots = Json::array();
    for (const PhysicalSlot& slot : compiled.slots) {
        slots.push_back({{"description", descText(slot.kind, slot.image, slot.buffer)},
                         {"usage", usageText(slot.kind, slot.imageUsage, slot.bufferUsage)}});
    }
    return {{"passes", passes}, {"resources", resources}, {"slots", slots}};
}

}  // namespace manylight
