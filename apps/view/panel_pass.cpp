#include "apps/view/panel_pass.h"

#include "engine/core/check.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/window.h"

#include <imgui.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace manylight {
namespace {

static_assert(sizeof(shared::PanelVertex) == sizeof(ImDrawVert));

/// A buffer that the host writes and shaders read, at least as large as `bytes`.
void reserve(gpu::Device& device, PhysicalBuffer& buffer, const char* name, size_t bytes) {
    if (buffer.buffer.exists() && buffer.buffer.size() >= bytes) return;
    buffer = {
        gpu::Buffer(device, name,
                    {std::max<size_t>(2 * bytes, 4096), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::MemoryKind::Upload}),
        {}};
}

/// FNV-1a by words of eight bytes.
uint64_t addBytes(uint64_t hash, const void* bytes, size_t count) {
    const auto* at = static_cast<const unsigned char*>(bytes);
    for (; count > 0;) {
        uint64_t word = 0;
        const size_t taken = std::min(count, sizeof word);
        std::memcpy(&word, at, taken);
        hash = (hash ^ word) * 0x100000001b3u;
        hash ^= hash >> 29;  // or the high bits of words would stay there
        at += taken;
        count -= taken;
    }
    return hash;
}

}  // namespace

uint64_t fingerprintOf(const ImDrawData& data) {
    uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&](const auto& value) { hash = addBytes(hash, &value, sizeof value); };
    add(data.DisplayPos);
    add(data.FramebufferScale);
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            add(command.ClipRect);
            add(command.ElemCount);
        }
        hash = addBytes(hash, list.IdxBuffer.Data, static_cast<size_t>(list.IdxBuffer.size_in_bytes()));
        hash = addBytes(hash, list.VtxBuffer.Data, static_cast<size_t>(list.VtxBuffer.size_in_bytes()));
    }
    return hash;
}

std::vector<PixelRect> panelRects(const ImDrawData& data) {
    const glm::vec2 origin(data.DisplayPos.x, data.DisplayPos.y);
    const glm::vec2 scale(data.FramebufferScale.x, data.FramebufferScale.y);
    std::vector<PixelRect> rects;
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        constexpr float kFar = std::numeric_limits<float>::max();
        glm::vec2 low(kFar);
        glm::vec2 high(-kFar);
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const glm::vec2 clipLow(command.ClipRect.x, command.ClipRect.y);
            const glm::vec2 clipHigh(command.ClipRect.z, command.ClipRect.w);
            for (uint32_t k = 0; k < command.ElemCount; ++k) {
                const auto index = command.VtxOffset + list.IdxBuffer[static_cast<int>(command.IdxOffset + k)];
                const ImVec2& vertex = list.VtxBuffer[static_cast<int>(index)].pos;
                const glm::vec2 place = glm::clamp(glm::vec2(vertex.x, vertex.y), clipLow, clipHigh);
                low = glm::min(low, place);
                high = glm::max(high, place);
            }
        }
        if (high.x > low.x && high.y > low.y)
            rects.push_back(
                {glm::ivec2(glm::floor((low - origin) * scale)), glm::ivec2(glm::ceil((high - origin) * scale))});
    }
    return rects;
}

PanelAtlas::PanelAtlas(gpu::Device& device) {
    unsigned char* coverage = nullptr;
    int width = 0;
    int height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&coverage, &width, &height);
    size_ = {width, height};
    const size_t bytes = size_t{size_.x} * size_.y;
    reserve(device, buffer_, "font", bytes);
    std::memcpy(buffer_.buffer.mapped(), coverage, bytes);
}

void PanelFrame::upload(gpu::Device& device, const ImDrawData& data) {
    reserve(device, vertices_, "panel vertices", static_cast<size_t>(data.TotalVtxCount) * sizeof(ImDrawVert));
    reserve(device, indices_, "panel indices", static_cast<size_t>(data.TotalIdxCount) * sizeof(uint32_t));
    origin_ = {data.DisplayPos.x, data.DisplayPos.y};
    scale_ = {data.FramebufferScale.x, data.FramebufferScale.y};
    draws_.clear();
    auto* vertices = static_cast<ImDrawVert*>(vertices_.buffer.mapped());
    auto* indices = static_cast<uint32_t*>(indices_.buffer.mapped());
    uint32_t vertexCount = 0;
    uint32_t indexCount = 0;
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            MANYLIGHT_CHECK(command.UserCallback == nullptr, "a panel that draws by itself");
            const glm::vec2 low = (glm::vec2(command.ClipRect.x, command.ClipRect.y) - origin_) * scale_;
            const glm::vec2 high = (glm::vec2(command.ClipRect.z, command.ClipRect.w) - origin_) * scale_;
            if (high.x > low.x && high.y > low.y && command.ElemCount > 0)
                draws_.push_back({{low, high}, indexCount, command.ElemCount});
            for (uint32_t k = 0; k < command.ElemCount; ++k)
                indices[indexCount++] =
                    vertexCount + command.VtxOffset + list.IdxBuffer[static_cast<int>(command.IdxOffset + k)];
        }
        std::copy(list.VtxBuffer.begin(), list.VtxBuffer.end(), vertices + vertexCount);
        vertexCount += static_cast<uint32_t>(list.VtxBuffer.Size);
    }
}

ImageHandle PanelFrame::add(FrameGraph& graph, PanelAtlas& atlas, ImageHandle layer, glm::uvec2 size) {
    PassBuilder clear = graph.addPass(std::string(kPanelPass) + "_clear");
    layer = clear.write(layer, Access::ColorWrite, VkClearValue{});
    clear.execute([](PassContext&) {});
    PassBuilder pass = graph.addPass(kPanelPass);
    pass.read(importPhysical(graph, "panel vertices", vertices_), Access::GraphicsStorageRead,
              shared::kBindingPanelVertices)
        .read(importPhysical(graph, "panel indices", indices_), Access::GraphicsStorageRead,
              shared::kBindingPanelIndices)
        .read(importPhysical(graph, "font", atlas.buffer()), Access::GraphicsStorageRead, shared::kBindingPanelAtlas);
    layer = pass.write(layer, Access::ColorBlend);
    pass.execute([this, size, atlasSize = atlas.size()](PassContext& context) {
        for (const Draw& draw : draws_)
            context.draw(
                {.vertexShader = "window_panel.vert", .fragmentShader = "window_panel.frag", .overBlend = true},
                draw.indexCount, shared::WindowPanelPush{draw.clip, origin_, scale_, size, atlasSize, draw.firstIndex});
    });
    return layer;
}

}  // namespace manylight
