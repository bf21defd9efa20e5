#include "engine/scene/gltf_container.h"

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/scene/json_view.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>

namespace manylight {
namespace {

constexpr uint32_t kMagic = 0x46546c67;      // "glTF"
constexpr uint32_t kJsonChunk = 0x4e4f534a;  // "JSON"
constexpr uint32_t kBinChunk = 0x004e4942;   // "BIN"
constexpr size_t kHeaderSize = 12;
constexpr size_t kChunkHeaderSize = 8;

uint32_t wordAt(std::string_view bytes, size_t offset) {
    uint32_t word = 0;
    for (size_t i = 0; i < 4; ++i) word |= uint32_t{static_cast<uint8_t>(bytes[offset + i])} << (8 * i);
    return word;
}

/// Returns the part of the file that the header claims.
std::string_view checkHeader(std::string_view bytes, const std::string& file, Warnings& warnings) {
    if (bytes.size() < kHeaderSize) fail("{}: truncated in the GLB header, expected 12 bytes", file);
    if (wordAt(bytes, 0) != kMagic) fail("{}: byte 0: expected the letters glTF", file);
    if (wordAt(bytes, 4) != 2) fail("{}: byte 4: expected GLB version 2, found {}", file, wordAt(bytes, 4));
    const size_t length = wordAt(bytes, 8);
    if (length > bytes.size() || length < kHeaderSize + kChunkHeaderSize)
        fail("{}: byte 8: the header claims {} bytes, the file has {}", file, length, bytes.size());
    if (length < bytes.size()) warnings.add("bytes after the end of the GLB ignored", {}, bytes.size() - length);
    return bytes.substr(0, length);
}

/// Splits a GLB into its JSON text and binary chunk. Chunks of other kinds may follow and are skipped.
std::string_view readChunks(std::string_view bytes, GltfContainer& gltf, Warnings& warnings) {
    bytes = checkHeader(bytes, gltf.file, warnings);
    std::string_view json;
    size_t chunkNumber = 0;
    for (size_t offset = kHeaderSize; offset < bytes.size(); ++chunkNumber) {
        if (bytes.size() - offset < kChunkHeaderSize) fail("{}: byte {}: truncated chunk header", gltf.file, offset);
        const size_t length = wordAt(bytes, offset);
        const uint32_t type = wordAt(bytes, offset + 4);
        if (length > bytes.size() - offset - kChunkHeaderSize)
            fail("{}: byte {}: chunk of {} bytes goes past the end of the file", gltf.file, offset, length);
        if (length % 4 != 0) fail("{}: byte {}: chunk length {} is no multiple of four", gltf.file, offset, length);
        const std::string_view data = bytes.substr(offset + kChunkHeaderSize, length);
        if ((chunkNumber == 0) != (type == kJsonChunk))
            fail("{}: byte {}: expected exactly one JSON chunk, first of all", gltf.file, offset);
        if (type == kBinChunk && chunkNumber != 1)
            fail("{}: byte {}: expected at most one BIN chunk, right after the JSON chunk", gltf.file, offset);
        if (type == kJsonChunk)
            json = data;
        else if (type == kBinChunk)
            gltf.binaryChunk.assign(data.begin(), data.end());
        else
            warnings.add("GLB chunks of unknown type ignored", fmt::format("byte {}", offset));
        offset += kChunkHeaderSize + length;
    }
    return json;
}

std::string percentDecoded(const std::string& uri) {
    const auto digit = [](char c) {
        constexpr std::string_view kDigits = "0123456789abcdef";
        return kDigits.find(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
    };
    std::string text;
    for (size_t i = 0; i < uri.size(); ++i) {
        const bool isEscape = uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) < 16 && digit(uri[i + 2]) < 16;
        if (!isEscape) {
            text += uri[i];
            continue;
        }
        text += static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2]));
        i += 2;
    }
    return text;
}

std::vector<uint8_t> readBuffer(const GltfContainer& gltf, const JsonView& buffer, size_t number) {
    const auto byteLength = static_cast<size_t>(buffer.at("byteLength").integer(1, int64_t{1} << 40));
    std::vector<uint8_t> bytes;
    if (buffer.has("uri"))
        bytes = readGltfUri(gltf, buffer.at("uri").text());
    else if (number == 0)
        bytes = gltf.binaryChunk;
    if (bytes.empty() && !buffer.has("uri")) fail("{}: has neither a uri nor a binary chunk", buffer.place());
    if (bytes.size() < byteLength)
        fail("{}: has {} bytes, expected byteLength {}", buffer.place(), bytes.size(), byteLength);
    return bytes;
}

}  // namespace

std::vector<uint8_t> readGltfUri(const GltfContainer& gltf, const std::string& uri) {
    if (tinygltf::IsDataURI(uri)) {
        std::vector<uint8_t> bytes;
        std::string mimeType;
        if (!tinygltf::DecodeDataURI(&bytes, mimeType, uri, 0, false))
            fail("{}: data URI cannot be decoded: {}...", gltf.file, uri.substr(0, 40));
        return bytes;
    }
    if (uri.find(':') != std::string::npos)
        fail("{}: uri \"{}\" is no relative path and no embedded data", gltf.file, uri.substr(0, 80));
    const std::string content = readTextFile(gltf.folder / percentDecoded(uri));
    return {content.begin(), content.end()};
}

GltfContainer openGltf(const std::filesystem::path& path, Warnings& warnings) {
    GltfContainer gltf;
    gltf.file = path.string();
    gltf.folder = path.parent_path();
    const std::string bytes = readTextFile(path);
    gltf.byteCount = bytes.size();
    const bool isBinary = path.extension() == ".glb" || path.extension() == ".GLB" || bytes.starts_with("glTF");
    std::string_view json = isBinary ? readChunks(bytes, gltf, warnings) : std::string_view(bytes);
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (json.starts_with(kByteOrderMark)) {
        json.remove_prefix(kByteOrderMark.size());
        warnings.add("byte order marks skipped", gltf.file);
    }
    gltf.json = parseJson(json, gltf.file);
    return gltf;
}

void loadGltfBuffers(GltfContainer& gltf, Warnings& warnings) {
    const JsonView root(gltf.json, gltf.file);
    if (!root.has("buffers")) return;
    const JsonView buffers = root.at("buffers");
    for (size_t i = 0; i < buffers.size(); ++i) {
        GltfBuffer buffer;
        try {
            buffer.bytes = readBuffer(gltf, buffers.at(i), i);
        } catch (const Error& error) {
            buffer.fault = error.what();
            warnings.add("buffers not readable", buffer.fault);
        }
        gltf.byteCount += buffer.bytes.size();
        gltf.buffers.push_back(std::move(buffer));
    }
}

}  // namespace manylight
