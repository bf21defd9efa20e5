// Member offsets and array strides of the structs in a SPIR-V module, by name: just enough of a reader for tests.
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <string>

namespace manylight::test {

/// Offsets by member name, of every struct that lies in a buffer; array strides by the element struct's name.
struct SpirvLayout {
    std::map<std::string, std::map<std::string, uint32_t>> offsets;
    std::map<std::string, uint32_t> strides;
};

inline SpirvLayout readSpirvLayout(std::span<const uint32_t> words) {
    enum : uint32_t {
        kName = 5,
        kMemberName = 6,
        kTypeArray = 28,
        kTypeRuntimeArray = 29,
        kDecorate = 71,
        kMemberDecorate = 72
    };
    enum : uint32_t { kDecorationArrayStride = 6, kDecorationOffset = 35 };
    constexpr size_t kHeaderWords = 5;
    std::map<uint32_t, std::string> names;
    std::map<uint32_t, std::map<uint32_t, std::string>> memberNames;
    std::map<uint32_t, std::map<uint32_t, uint32_t>> memberOffsets;
    std::map<uint32_t, uint32_t> elementOfArray;
    std::map<uint32_t, uint32_t> strideOfArray;
    const auto text = [](const uint32_t* word) { return std::string(reinterpret_cast<const char*>(word)); };

    for (size_t i = kHeaderWords; i < words.size(); i += words[i] >> 16) {
        const uint32_t* const word = &words[i];
        switch (word[0] & 0xffffu) {
            case kName:
                names[word[1]] = text(word + 2);
                break;
            case kMemberName:
                memberNames[word[1]][word[2]] = text(word + 3);
                break;
            case kTypeArray:
            case kTypeRuntimeArray:
                elementOfArray[word[1]] = word[2];
                break;
            case kDecorate:
                if (word[2] == kDecorationArrayStride) strideOfArray[word[1]] = word[3];
                break;
            case kMemberDecorate:
                if (word[3] == kDecorationOffset) memberOffsets[word[1]][word[2]] = word[4];
                break;
            default:
                break;
        }
    }

    SpirvLayout layout;
    for (const auto& [type, offsets] : memberOffsets)
        for (const auto& [member, offset] : offsets) layout.offsets[names[type]][memberNames[type][member]] = offset;
    for (const auto& [array, stride] : strideOfArray) layout.strides[names[elementOfArray[array]]] = stride;
    return layout;
}

}  // namespace manylight::test
