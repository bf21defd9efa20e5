// The run report: what a program did, as JSON, with every warning counted.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace manylight {

using Json = nlohmann::ordered_json;

/// Collects repairs and oddities while a scene is read or a picture is made. Each kind is counted; the first few
/// places where it happened are kept as examples. Nothing that was dropped or repaired goes unreported.
class Warnings {
  public:
    struct Entry {
        uint64_t count = 0;
        std::vector<std::string> examples;  // at most kMaxExamples
    };
    static constexpr size_t kMaxExamples = 3;

    /// `kind` is a short stable phrase ("degenerate triangles dropped"), `place` says where ("line 12").
    void add(std::string_view kind, std::string_view place = {}, uint64_t count = 1);
    void merge(const Warnings& other);
    bool empty() const { return entries_.empty(); }
    uint64_t total() const;
    uint64_t count(std::string_view kind) const;
    const std::map<std::string, Entry, std::less<>>& entries() const { return entries_; }
    Json toJson() const;
    /// One line per kind: "3 degenerate triangles dropped (face 7, face 9, face 12)".
    std::string toText() const;

  private:
    std::map<std::string, Entry, std::less<>> entries_;
};

}  // namespace manylight
