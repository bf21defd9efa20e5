// Files are written beside their target and renamed, so that a reader never meets half of one.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace manylight {

/// Calls `write` with a temporary path in the target's folder, then renames it to `target`. On any exception the
/// temporary is removed and nothing changed. Throws Error if the folder is missing or cannot be written.
void writeAtomically(const std::filesystem::path& target,
                     const std::function<void(const std::filesystem::path&)>& write);

/// Throws the Error that writeAtomically() would throw for a missing folder or a folder in the file's place: for
/// programs that work for long before they write.
void requireWritable(const std::filesystem::path& target);

/// Writes `text` to `target` atomically.
void writeTextFile(const std::filesystem::path& target, std::string_view text);

/// Whether `path` leads to an ordinary file; false too if the system refuses the name.
bool isRegularFile(const std::filesystem::path& path);

/// Whole content of an ordinary file (a device might never end). Throws Error naming the file if it cannot be read.
std::string readTextFile(const std::filesystem::path& source);

}  // namespace manylight
