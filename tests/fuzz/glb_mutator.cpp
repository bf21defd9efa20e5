#include "tests/fuzz/glb_mutator.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>

namespace manylight::fuzz {
namespace {

constexpr size_t kHeaderSize = 12;
constexpr size_t kChunkHeaderSize = 8;
constexpr uint32_t kJsonChunk = 0x4e4f534a;
constexpr uint32_t kBinChunk = 0x004e4942;

struct Chunks {
    std::string json;
    std::string binary;
};

uint32_t wordAt(const std::string& bytes, size_t offset) {
    uint32_t word = 0;
    std::memcpy(&word, bytes.data() + offset, sizeof word);
    return word;
}

/// Takes the chunk at `offset` and moves on; the length may claim more than there is.
std::optional<std::string> takeChunk(const std::string& bytes, size_t& offset) {
    if (bytes.size() < offset + kChunkHeaderSize) return std::nullopt;
    const std::string chunk = bytes.substr(offset + kChunkHeaderSize, wordAt(bytes, offset));
    offset += kChunkHeaderSize + chunk.size();
    return chunk;
}

std::optional<Chunks> split(const std::string& bytes) {
    if (bytes.size() < kHeaderSize || !bytes.starts_with("glTF")) return std::nullopt;
    size_t offset = kHeaderSize;
    const auto json = takeChunk(bytes, offset);
    if (!json) return std::nullopt;
    return Chunks{*json, takeChunk(bytes, offset).value_or("")};
}

void appendWords(std::string& bytes, std::initializer_list<size_t> words) {
    for (const size_t value : words) {
        const auto word = static_cast<uint32_t>(value);
        bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
    }
}

std::string join(Chunks chunks) {
    chunks.json.resize((chunks.json.size() + 3) / 4 * 4, ' ');
    chunks.binary.resize((chunks.binary.size() + 3) / 4 * 4, '\0');
    const size_t binarySize = chunks.binary.empty() ? 0 : kChunkHeaderSize + chunks.binary.size();
    std::string bytes = "glTF";
    appendWords(bytes, {2, kHeaderSize + kChunkHeaderSize + chunks.json.size() + binarySize});
    appendWords(bytes, {chunks.json.size(), kJsonChunk});
    bytes += chunks.json;
    if (chunks.binary.empty()) return bytes;
    appendWords(bytes, {chunks.binary.size(), kBinChunk});
    return bytes + chunks.binary;
}

}  // namespace

size_t mutateGlb(uint8_t* data, size_t size, size_t mostBytes, unsigned int seed, Mutate mutate) {
    std::optional<Chunks> chunks = split({reinterpret_cast<const char*>(data), size});
    if (!chunks || seed % 8 == 0) return mutate(data, size, mostBytes);
    std::string& chunk = seed % 8 < 6 ? chunks->json : chunks->binary;
    const size_t oldSize = chunk.size();
    chunk.resize(std::max(mostBytes, oldSize));
    chunk.resize(mutate(reinterpret_cast<uint8_t*>(chunk.data()), oldSize, chunk.size()));
    const std::string bytes = join(*chunks);
    if (bytes.size() > mostBytes) return mutate(data, size, mostBytes);
    std::memcpy(data, bytes.data(), bytes.size());
    return bytes.size();
}

}  // namespace manylight::fuzz
