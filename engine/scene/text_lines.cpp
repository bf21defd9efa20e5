#include "engine/scene/text_lines.h"

#include <algorithm>
#include <charconv>

namespace manylight {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0'; }

}  // namespace

std::string_view TextLines::takePhysicalLine() {
    const size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    const std::string_view line = rest_.substr(0, end);
    const bool endsInCrLf = rest_.substr(end, 2) == "\r\n";
    rest_.remove_prefix(std::min(rest_.size(), end + (endsInCrLf ? 2 : 1)));
    ++linesTaken_;
    return line;
}

bool TextLines::next() {
    if (rest_.empty()) return false;
    number_ = linesTaken_ + 1;
    line_ = takePhysicalLine();
    if (!line_.ends_with('\\')) return true;
    joined_.assign(line_);
    while (joined_.ends_with('\\') && !rest_.empty()) {
        joined_.back() = ' ';
        joined_ += takePhysicalLine();
    }
    line_ = joined_;
    return true;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

std::string_view takeWord(std::string_view& rest) {
    size_t begin = 0;
    while (begin < rest.size() && isBlank(rest[begin])) ++begin;
    size_t end = begin;
    while (end < rest.size() && !isBlank(rest[end])) ++end;
    const std::string_view word = rest.substr(begin, end - begin);
    rest.remove_prefix(end);
    return word;
}

std::optional<double> parseNumber(std::string_view word) {
    if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
}

}  // namespace manylight
