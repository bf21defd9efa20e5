// Line-based text files (OBJ, MTL): lines with their numbers, words, exact numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace manylight {

/// Walks the lines of a text. LF, CR LF and CR end a line; a backslash before the end continues it on the next.
class TextLines {
  public:
    explicit TextLines(std::string_view text) : rest_(text) {}

    /// Steps to the next line; false at the end. The line is valid until the next call.
    bool next();
    std::string_view line() const { return line_; }
    uint32_t number() const { return number_; }  // of the line's first physical line, counted from 1

  private:
    std::string_view takePhysicalLine();

    std::string_view rest_;
    std::string_view line_;
    std::string joined_;
    uint32_t number_ = 0;
    uint32_t linesTaken_ = 0;
};

/// Text without the blanks at both ends.
std::string_view trimmed(std::string_view text);

/// Takes the first word off `rest`; empty at the end.
std::string_view takeWord(std::string_view& rest);

/// The whole word as a number, correctly rounded. "nan" and "inf" are numbers here. Empty if it is anything else or out
/// of double's range.
std::optional<double> parseNumber(std::string_view word);

}  // namespace manylight
