// The two kinds of failure: Error is the world's fault (file, device, arguments), BugError is ours.
#pragma once

#include <fmt/core.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace manylight {

/// `text` with a question mark for each control character: names in files may have line ends, or worse, in them.
std::string printable(std::string_view text);

/// The world's fault. The message is one line: which file or device, the place in it, what was expected.
/// Caught only in main(), which prints it and exits with `exitCode` (1: world's fault, 2: usage).
class Error : public std::runtime_error {
  public:
    /// Keeps what is printable() of `message`.
    explicit Error(const std::string& message, int exitCode = 1);
    int exitCode() const { return exitCode_; }

  private:
    int exitCode_;
};

/// Our fault: a violated invariant. Thrown by MANYLIGHT_CHECK.
class BugError : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

/// Throws Error with a formatted message: `fail("{}: line {}: expected {}", path, line, what)`.
template <typename... Args>
[[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) {
    throw Error(fmt::format(format, std::forward<Args>(args)...));
}

/// Like fail(), for wrong arguments of a program: exit code 2.
template <typename... Args>
[[noreturn]] void failUsage(fmt::format_string<Args...> format, Args&&... args) {
    throw Error(fmt::format(format, std::forward<Args>(args)...), 2);
}

}  // namespace manylight
