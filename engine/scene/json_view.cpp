#include "engine/scene/json_view.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

// Parsers and converters downstream may recurse once per level.
constexpr int kDeepestNesting = 100;

/// The library's message without its own prefix "[json.exception...] ".
std::string reasonOf(const Json::exception& error) {
    std::string reason = error.what();
    if (const size_t end = reason.find("] "); end != std::string::npos) reason.erase(0, end + 2);
    std::replace_if(
        reason.begin(), reason.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return reason;
}

}  // namespace

Json parseJson(std::string_view text, const std::string& file) {
    const auto limitDepth = [&](int depth, Json::parse_event_t, Json&) {
        if (depth > kDeepestNesting) fail("{}: JSON nested deeper than {} levels", file, kDeepestNesting);
        return true;
    };
    try {
        return Json::parse(text.begin(), text.end(), limitDepth);
    } catch (const Json::exception& error) {
        fail("{}: not valid JSON: {}", file, reasonOf(error));
    }
}

std::string JsonView::place() const { return fmt::format("{}: {}", *file_, path()); }

void JsonView::failExpected(std::string_view expected) const {
    std::string found = value_->dump(-1, ' ', true, Json::error_handler_t::replace);
    if (found.size() > 40) found = found.substr(0, 40) + "...";
    fail("{}: expected {}, found {}", place(), expected, found);
}

JsonView JsonView::at(std::string_view key) const {
    expectObject();
    const auto found = value_->find(key);
    if (found == value_->end()) fail("{}: missing key \"{}\"", place(), key);
    return {*found, *file_, path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key)};
}

JsonView JsonView::at(size_t index) const {
    expectArray();
    if (index >= value_->size()) fail("{}: expected an element {}, found {} elements", place(), index, value_->size());
    return {(*value_)[index], *file_, fmt::format("{}[{}]", path_, index)};
}

const JsonView& JsonView::expectObject() const {
    if (!value_->is_object()) failExpected("an object");
    return *this;
}

const JsonView& JsonView::expectArray() const {
    if (!value_->is_array()) failExpected("an array");
    return *this;
}

void JsonView::expectKeys(std::initializer_list<std::string_view> known) const {
    expectObject();
    for (const auto& [key, value] : value_->items()) {
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        const std::string path = path_.empty() ? key : fmt::format("{}.{}", path_, key);
        fail("{}: {}: unknown key, expected one of {}", *file_, path, fmt::join(known, ", "));
    }
}

bool JsonView::boolean() const {
    if (!value_->is_boolean()) failExpected("true or false");
    return value_->get<bool>();
}

std::string JsonView::text() const {
    if (!value_->is_string()) failExpected("a text");
    return value_->get<std::string>();
}

double JsonView::number() const {
    if (!value_->is_number() || !std::isfinite(value_->get<double>())) failExpected("a finite number");
    return value_->get<double>();
}

double JsonView::positiveNumber() const {
    if (!(number() > 0.0)) failExpected("a number above zero");
    return number();
}

int64_t JsonView::integer(int64_t least, int64_t most) const {
    const bool fits = value_->is_number_integer() &&
                      (!value_->is_number_unsigned() || value_->get<uint64_t>() <= uint64_t{INT64_MAX}) &&
                      value_->get<int64_t>() >= least && value_->get<int64_t>() <= most;
    if (!fits) failExpected(fmt::format("an integer in [{}, {}]", least, most));
    return value_->get<int64_t>();
}

glm::dvec3 JsonView::vector3() const {
    if (!value_->is_array() || size() != 3) failExpected("three numbers");
    return {at(size_t{0}).number(), at(size_t{1}).number(), at(size_t{2}).number()};
}

glm::dvec3 JsonView::nonNegative3() const {
    const glm::dvec3 v = vector3();
    if (!(v.x >= 0.0 && v.y >= 0.0 && v.z >= 0.0)) failExpected("three numbers, none negative");
    return v;
}

}  // namespace manylight
