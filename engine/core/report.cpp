#include "engine/core/report.h"

#include "engine/core/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace manylight {

void Warnings::add(std::string_view kind, std::string_view place, uint64_t count) {
    if (count == 0) return;
    auto it = entries_.find(kind);
    if (it == entries_.end()) it = entries_.emplace(std::string(kind), Entry{}).first;
    it->second.count += count;
    if (!place.empty() && it->second.examples.size() < kMaxExamples) it->second.examples.push_back(printable(place));
}

void Warnings::merge(const Warnings& other) {
    for (const auto& [kind, entry] : other.entries_) {
        add(kind, {}, entry.count);
        auto& examples = entries_.find(kind)->second.examples;
        for (const auto& example : entry.examples)
            if (examples.size() < kMaxExamples) examples.push_back(example);
    }
}

uint64_t Warnings::total() const {
    uint64_t sum = 0;
    for (const auto& [kind, entry] : entries_) sum += entry.count;
    return sum;
}

uint64_t Warnings::count(std::string_view kind) const {
    const auto it = entries_.find(kind);
    return it == entries_.end() ? 0 : it->second.count;
}

Json Warnings::toJson() const {
    Json json = Json::array();
    for (const auto& [kind, entry] : entries_)
        json.push_back({{"what", kind}, {"count", entry.count}, {"examples", entry.examples}});
    return json;
}

std::string Warnings::toText() const {
    std::string text;
    for (const auto& [kind, entry] : entries_)
        text += fmt::format("{} {}{}\n", entry.count, kind,
                            entry.examples.empty() ? "" : fmt::format(" ({})", fmt::join(entry.examples, ", ")));
    return text;
}

}  // namespace manylight
