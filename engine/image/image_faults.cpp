#include "engine/image/image_faults.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace manylight {
namespace {

using Bytes = std::span<const uint8_t>;

constexpr std::array<uint8_t, 8> kPngSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

bool isPng(Bytes bytes) {
    return bytes.size() >= kPngSignature.size() &&
           std::equal(kPngSignature.begin(), kPngSignature.end(), bytes.begin());
}

/// A chunk: its length, its name, so many bytes, a checksum.
bool hasChunkBehindTheEnd(Bytes png) {
    constexpr size_t kChunkHeaderSize = 8;
    constexpr size_t kChecksumSize = 4;
    constexpr std::array<uint8_t, 4> kLastChunk{'I', 'E', 'N', 'D'};
    Bytes rest = png.subspan(kPngSignature.size());
    while (rest.size() >= kChunkHeaderSize) {
        size_t length = 0;
        for (size_t i = 0; i < 4; ++i) length = length << 8 | rest[i];
        if (length > rest.size() - kChunkHeaderSize) return true;
        if (std::equal(kLastChunk.begin(), kLastChunk.end(), rest.begin() + 4)) return false;
        rest = rest.subspan(std::min(rest.size(), kChunkHeaderSize + length + kChecksumSize));
    }
    return false;
}

constexpr uint8_t kMarkerPrefix = 0xff;
constexpr uint8_t kStartOfImage = 0xd8;
constexpr uint8_t kEndOfImage = 0xd9;
constexpr uint8_t kHuffmanTables = 0xc4;

/// `rest` begins with the tables of a segment of `length` bytes. A table: its number, 16 counts of codes, the codes.
/// The decoder reads it whole, past the end of the segment too, and past the end of the file, where it finds zeros.
bool hasOversizedTable(Bytes rest, size_t length) {
    constexpr size_t kCounts = 16;
    constexpr size_t kMostCodes = 256;
    for (size_t at = 0; at < length && at + 1 < rest.size();) {
        const Bytes counts = rest.subspan(at + 1, std::min(kCounts, rest.size() - at - 1));
        const size_t codes = std::accumulate(counts.begin(), counts.end(), size_t{0});
        if (codes > kMostCodes) return true;
        at += 1 + kCounts + codes;
    }
    return false;
}

/// Moves past the next marker and returns it. Coded data, like padding, goes on to a prefix that no stuffed zero
/// follows.
uint8_t takeMarker(Bytes bytes, size_t& at) {
    while (at < bytes.size() && bytes[at] != kMarkerPrefix) ++at;
    while (at < bytes.size() && bytes[at] == kMarkerPrefix) ++at;
    return at < bytes.size() ? bytes[at++] : kEndOfImage;
}

/// Markers without a segment: stuffed zeros of the coded data, restarts, start of the image.
bool isAlone(uint8_t marker) { return marker <= 0x01 || (marker >= 0xd0 && marker <= kStartOfImage); }

bool isJpeg(Bytes bytes) {
    size_t at = 0;
    return !bytes.empty() && bytes[0] == kMarkerPrefix && takeMarker(bytes, at) == kStartOfImage;
}

bool hasOversizedHuffmanTable(Bytes jpeg) {
    size_t at = 0;
    for (uint8_t marker = takeMarker(jpeg, at); marker != kEndOfImage; marker = takeMarker(jpeg, at)) {
        if (isAlone(marker)) continue;
        if (at + 2 > jpeg.size()) return false;
        const size_t length = size_t{jpeg[at]} << 8 | jpeg[at + 1];  // counts itself
        if (marker == kHuffmanTables && length > 2 && hasOversizedTable(jpeg.subspan(at + 2), length - 2)) return true;
        at += std::max<size_t>(length, 2);
    }
    return false;
}

}  // namespace

const char* imageFault(Bytes bytes) {
    if (isPng(bytes) && hasChunkBehindTheEnd(bytes)) return "a chunk goes past the end of the file";
    if (isJpeg(bytes) && hasOversizedHuffmanTable(bytes)) return "a Huffman table of more than 256 codes";
    return nullptr;
}

}  // namespace manylight
