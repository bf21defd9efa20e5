// A value in a JSON file that knows its place, so that every complaint names the file and the path.
#pragma once

#include "engine/core/error.h"
#include "engine/core/report.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace manylight {

/// Parses a JSON text. Throws Error naming `file` for malformed text and for nesting deeper than any scene needs.
Json parseJson(std::string_view text, const std::string& file);

/// Refers to `value` and `file`, which must outlive it. Every accessor throws Error("file: path: what was expected").
class JsonView {
  public:
    JsonView(const Json& value, const std::string& file, std::string path = {})
        : value_(&value), file_(&file), path_(std::move(path)) {}

    const Json& json() const { return *value_; }
    /// "file: path", for messages and warnings.
    std::string place() const;
    const std::string& file() const { return *file_; }
    std::string path() const { return path_.empty() ? "top level" : path_; }
    [[noreturn]] void failExpected(std::string_view expected) const;

    bool has(std::string_view key) const { return value_->is_object() && value_->contains(key); }
    JsonView at(std::string_view key) const;  // the value must be an object with this key
    JsonView at(size_t index) const;          // the value must be an array with this element
    size_t size() const { return value_->size(); }
    const JsonView& expectObject() const;
    const JsonView& expectArray() const;
    /// The value must be an object with no other keys.
    void expectKeys(std::initializer_list<std::string_view> known) const;

    bool boolean() const;
    std::string text() const;
    double number() const;  // finite
    double positiveNumber() const;
    int64_t integer(int64_t least, int64_t most) const;
    glm::dvec3 vector3() const;
    glm::dvec3 nonNegative3() const;

  private:
    const Json* value_;
    const std::string* file_;
    std::string path_;
};

}  // namespace manylight
