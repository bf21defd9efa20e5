#include "engine/graph/frame_graph.h"

#include "engine/core/check.h"

#include <utility>

namespace manylight {

namespace {

bool isTexelRead(const AccessInfo& info) { return info.bufferDescriptor == VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER; }

void checkFits(const Pass& pass, const Resource& resource, const AccessInfo& info, const PassUse& use) {
    const bool isImage = resource.kind == ResourceKind::Image;
    const bool fits = isImage ? fitsImages(info) : fitsBuffers(info);
    const bool hasDescriptor = (isImage ? info.imageDescriptor : info.bufferDescriptor) != kNoDescriptor;
    const auto where = [&] { return fmt::format("pass '{}', resource '{}', {}", pass.name, resource.name, info.name); };
    MANYLIGHT_CHECK(fits, "{}: not an access to {}", where(), isImage ? "images" : "buffers");
    MANYLIGHT_CHECK((hasDescriptor || use.binding == kNoBinding), "{}: takes no binding", where());
    MANYLIGHT_CHECK((isAttachment(info) || !use.clear), "{}: only attachments are cleared", where());
    MANYLIGHT_CHECK((!isTexelRead(info) || resource.buffer.texelFormat != VK_FORMAT_UNDEFINED),
                    "{}: the buffer has no texel format", where());
}

void checkAgainstEarlierUses(const Pass& pass, const std::vector<Resource>& resources, const PassUse& use) {
    const std::string& name = resources[use.resource].name;
    for (const PassUse& earlier : pass.uses) {
        MANYLIGHT_CHECK(earlier.resource != use.resource, "pass '{}': double access to '{}'", pass.name, name);
        MANYLIGHT_CHECK((use.binding == kNoBinding || earlier.binding != use.binding),
                        "pass '{}': '{}' and '{}' share binding {}", pass.name, resources[earlier.resource].name, name,
                        use.binding);
    }
}

}  // namespace

ImageHandle FrameGraph::createImage(std::string name, const ImageDesc& desc) {
    return {addResource({.name = std::move(name), .kind = ResourceKind::Image, .image = desc}), 0};
}

BufferHandle FrameGraph::createBuffer(std::string name, const BufferDesc& desc) {
    return {addResource({.name = std::move(name), .kind = ResourceKind::Buffer, .buffer = desc}), 0};
}

ImageHandle FrameGraph::importImage(std::string name, const ImageDesc& desc, ResourceState initial, void* external) {
    Resource resource{.name = std::move(name), .kind = ResourceKind::Image, .image = desc, .imported = true};
    resource.external = external;
    resource.hasContent = initial.layout != VK_IMAGE_LAYOUT_UNDEFINED;
    resource.initial = std::move(initial);
    return {addResource(std::move(resource)), 0};
}

BufferHandle FrameGraph::importBuffer(std::string name, const BufferDesc& desc, ResourceState initial, void* external) {
    Resource resource{.name = std::move(name), .kind = ResourceKind::Buffer, .buffer = desc, .imported = true};
    resource.external = external;
    resource.hasContent = true;
    resource.initial = std::move(initial);
    return {addResource(std::move(resource)), 0};
}

uint32_t FrameGraph::addResource(Resource resource) {
    if (resource.kind == ResourceKind::Image) {
        MANYLIGHT_CHECK(resource.image.format != VK_FORMAT_UNDEFINED, "image '{}' has no format", resource.name);
        MANYLIGHT_CHECK((resource.image.width > 0 && resource.image.height > 0), "image '{}' is empty", resource.name);
    } else {
        MANYLIGHT_CHECK(resource.buffer.size > 0u, "buffer '{}' is empty", resource.name);
    }
    resources_.push_back(std::move(resource));
    return static_cast<uint32_t>(resources_.size() - 1);
}

PassBuilder FrameGraph::addPass(std::string name) {
    passes_.emplace_back().name = std::move(name);
    return {*this, static_cast<uint32_t>(passes_.size() - 1)};
}

Resource& FrameGraph::current(const std::string& user, ResourceKind kind, uint32_t resource, uint32_t version) {
    MANYLIGHT_CHECK(resource < resources_.size(), "{}: unknown resource handle", user);
    Resource& found = resources_[resource];
    MANYLIGHT_CHECK(found.kind == kind, "{}: unknown handle, '{}' is of the other kind", user, found.name);
    MANYLIGHT_CHECK(version == found.version, "{}: stale handle to '{}'", user, found.name);
    return found;
}

void FrameGraph::keepResult(ResourceKind kind, uint32_t resource, uint32_t version) {
    Resource& kept = current("keep", kind, resource, version);
    MANYLIGHT_CHECK(kept.hasContent, "keep: '{}' was never written", kept.name);
    kept.kept = true;
}

uint32_t FrameGraph::addUse(uint32_t passIndex, ResourceKind kind, PassUse use, bool isWrite) {
    Pass& pass = passes_[passIndex];
    MANYLIGHT_CHECK(passIndex + 1 == passes_.size(), "pass '{}': extended after the next was added", pass.name);
    Resource& resource = current(fmt::format("pass '{}'", pass.name), kind, use.resource, use.versionBefore);
    const AccessInfo& info = accessInfo(use.access);
    checkFits(pass, resource, info, use);
    checkAgainstEarlierUses(pass, resources_, use);
    MANYLIGHT_CHECK(info.writes == isWrite, "pass '{}', resource '{}': {} given to {}()", pass.name, resource.name,
                    info.name, isWrite ? "write" : "read");

    // What an attachment held is needed unless it is cleared; for the others the access itself says it.
    use.needsContent = isAttachment(info) ? !use.clear : info.reads;
    MANYLIGHT_CHECK((resource.hasContent || !use.needsContent), "pass '{}': '{}' is read before anything wrote it",
                    pass.name, resource.name);
    if (isWrite) {
        MANYLIGHT_CHECK(!resource.kept, "pass '{}': overwrites '{}', which is kept", pass.name, resource.name);
        ++resource.version;
        resource.hasContent = true;
    }
    use.versionAfter = resource.version;
    pass.uses.push_back(use);
    return use.versionAfter;
}

PassBuilder& PassBuilder::keep(std::string reason) {
    Pass& pass = graph_.passes_[pass_];
    MANYLIGHT_CHECK(!reason.empty(), "pass '{}': kept without a reason", pass.name);
    pass.keepReason = std::move(reason);
    return *this;
}

}  // namespace manylight
