// The ways a file takes into the engine, each as a function of its bytes: what the fuzzers call, and the corpus test.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace manylight::fuzz {

/// How reading ended. A reader may throw nothing but Error, and `error` is its message; `summary` says what was read.
struct Outcome {
    std::string error;
    std::string summary;
};

struct Reader {
    std::string_view name;  // the fuzzer's, and its corpus' folder
    Outcome (*read)(std::string_view bytes);
};

/// All readers. They put `bytes` into a file of a folder of this process, beside files that the input may refer to.
std::span<const Reader> readers();

/// Reads and checks what came out: a scene whose every number the renderer can use, or an Error of one line. Throws
/// BugError, or whatever the reader threw, if it is neither.
Outcome readAndCheck(std::string_view readerName, std::string_view bytes);

}  // namespace manylight::fuzz
