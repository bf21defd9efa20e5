// Shaders compiled again while the program runs, when their sources change.
#pragma once

#include "engine/gpu/pipeline.h"

#include <filesystem>
#include <future>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace manylight {

/// An entry point whose source, or one that it includes, has changed.
struct CompiledShader {
    std::string name;  // "vpl_light.comp"
    std::vector<uint32_t> words;
    std::string problem;  // the compiler's, with file and line; empty if it went well
};

class ShaderReloader {
  public:
    /// `tree` has shaders/passes/. Throws Error if it has not. `rayQueries`: for a device that traces rays itself.
    explicit ShaderReloader(const std::filesystem::path& tree, bool rayQueries = false);

    /// The shaders that changed since the last call, compiled by glslangValidator.
    std::vector<CompiledShader> compileChanged();

    /// compileChanged() on a thread of its own, if none is at it.
    void start();
    bool isRunning() const { return running_.valid(); }
    /// What the thread compiled, once; empty until it is done. Throws what compileChanged() threw.
    std::optional<std::vector<CompiledShader>> take();

  private:
    using Time = std::filesystem::file_time_type;
    std::map<std::filesystem::path, Time> sourceTimes() const;
    std::set<std::filesystem::path> sourcesOf(const std::filesystem::path& entryPoint) const;
    CompiledShader compile(const std::filesystem::path& entryPoint, bool rayQuery) const;

    std::filesystem::path tree_;
    bool rayQueries_;
    std::map<std::filesystem::path, Time> known_;
    std::future<std::vector<CompiledShader>> running_;  // last, so that it ends first
};

}  // namespace manylight
