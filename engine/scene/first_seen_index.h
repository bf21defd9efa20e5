// Gives equal keys the same number, counted in order of first appearance.
#pragma once

#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace manylight {

/// Mixes one more 64-bit word into a hash.
inline uint64_t mixHash(uint64_t hash, uint64_t word) {
    hash = (hash ^ word) * 0x9e3779b97f4a7c15ull;
    return hash ^ (hash >> 29);
}

/// Open addressing with linear probing. `Key` needs operator== and a member `uint64_t hash() const`.
template <typename Key>
class FirstSeenIndex {
  public:
    explicit FirstSeenIndex(size_t expectedKeys) : slots_(std::bit_ceil(2 * expectedKeys + 16), kFree) {
        keys_.reserve(expectedKeys);
    }

    uint32_t indexOf(const Key& key) {
        if (2 * (keys_.size() + 1) > slots_.size()) grow();
        uint32_t& slot = slots_[findSlot(key)];
        if (slot == kFree) {
            slot = static_cast<uint32_t>(keys_.size());
            keys_.push_back(key);
        }
        return slot;
    }

    const std::vector<Key>& keys() const { return keys_; }
    std::vector<Key> takeKeys() && { return std::move(keys_); }

  private:
    static constexpr uint32_t kFree = UINT32_MAX;

    size_t findSlot(const Key& key) const {
        const size_t mask = slots_.size() - 1;
        size_t slot = key.hash() & mask;
        while (slots_[slot] != kFree && !(keys_[slots_[slot]] == key)) slot = (slot + 1) & mask;
        return slot;
    }

    void grow() {
        slots_.assign(slots_.size() * 2, kFree);
        for (size_t i = 0; i < keys_.size(); ++i) slots_[findSlot(keys_[i])] = static_cast<uint32_t>(i);
    }

    std::vector<uint32_t> slots_;
    std::vector<Key> keys_;
};

}  // namespace manylight
