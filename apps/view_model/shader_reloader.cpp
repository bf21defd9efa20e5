#include "apps/view_model/shader_reloader.h"

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/gpu/shader.h"

#include <unistd.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>

namespace manylight {
namespace {

namespace fs = std::filesystem;

bool isEntryPoint(const fs::path& file) {
    return file.extension() == ".comp" || file.extension() == ".vert" || file.extension() == ".frag";
}

/// In single quotes, for the shell.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

/// Output of a command, and whether it ended well.
std::pair<std::string, bool> runCommand(const std::string& command) {
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) return {"glslangValidator could not be run", false};
    std::string output;
    std::array<char, 4096> piece{};
    while (const size_t count = fread(piece.data(), 1, piece.size(), pipe)) output.append(piece.data(), count);
    return {output, pclose(pipe) == 0};
}

/// The first line that says what is wrong and where, as "ERROR: file:12: ...".
std::string firstError(const std::string& output) {
    size_t start = output.find("ERROR: ");
    if (start == std::string::npos) start = 0;
    return output.substr(start, output.find('\n', start) - start);
}

}  // namespace

ShaderReloader::ShaderReloader(const fs::path& tree, bool rayQueries) : tree_(tree), rayQueries_(rayQueries) {
    if (!fs::is_directory(tree_ / "shaders" / "passes"))
        failUsage("--watch-shaders {}: expected a folder that has shaders/passes", tree.string());
    known_ = sourceTimes();
}

std::map<fs::path, ShaderReloader::Time> ShaderReloader::sourceTimes() const {
    std::map<fs::path, Time> times;
    std::error_code problem;  // a file may vanish while an editor saves it
    for (const auto& entry : fs::recursive_directory_iterator(tree_ / "shaders", problem))
        if (entry.is_regular_file(problem)) times[entry.path().lexically_normal()] = entry.last_write_time(problem);
    return times;
}

std::set<fs::path> ShaderReloader::sourcesOf(const fs::path& entryPoint) const {
    std::set<fs::path> found;
    std::vector<fs::path> open = {entryPoint.lexically_normal()};
    while (!open.empty()) {
        const fs::path file = open.back();
        open.pop_back();
        if (!isRegularFile(file) || !found.insert(file).second) continue;
        const std::string text = readTextFile(file);
        const std::string mark = "#include \"";
        for (size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1)) {
            const size_t start = at + mark.size();
            open.push_back((tree_ / text.substr(start, text.find('"', start) - start)).lexically_normal());
        }
    }
    return found;
}

std::vector<CompiledShader> ShaderReloader::compileChanged() {
    const std::map<fs::path, Time> times = sourceTimes();
    std::set<fs::path> changed;
    for (const auto& [file, time] : times)
        if (const auto before = known_.find(file); before == known_.end() || before->second != time)
            changed.insert(file);
    known_ = times;
    std::vector<CompiledShader> compiled;
    if (changed.empty()) return compiled;
    for (const auto& [file, time] : times) {
        if (!isEntryPoint(file)) continue;
        const std::set<fs::path> sources = sourcesOf(file);
        const auto isChanged = [&](const fs::path& source) { return changed.contains(source); };
        if (std::none_of(sources.begin(), sources.end(), isChanged)) continue;
        compiled.push_back(compile(file, false));
        const bool traces = sources.contains((tree_ / "shaders" / "lib" / "traces.glsl").lexically_normal());
        if (traces && rayQueries_) compiled.push_back(compile(file, true));
    }
    return compiled;
}

void ShaderReloader::start() {
    if (!isRunning()) running_ = std::async(std::launch::async, [this] { return compileChanged(); });
}

std::optional<std::vector<CompiledShader>> ShaderReloader::take() {
    if (!isRunning() || running_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
    return running_.get();
}

CompiledShader ShaderReloader::compile(const fs::path& entryPoint, bool rayQuery) const {
    CompiledShader shader;
    shader.name = entryPoint.filename().string();
    if (rayQuery) shader.name = gpu::rayQueryVariant(shader.name);
    const fs::path output = fs::temp_directory_path() / fmt::format("manylight-{}-{}.spv", getpid(), shader.name);
    const auto [text, isDone] = runCommand(fmt::format(
        "glslangValidator --quiet -V --target-env vulkan1.3 {} -I{} -o {} {}", rayQuery ? "-DMANYLIGHT_RAY_QUERY" : "",
        quoted(tree_.string()), quoted(output.string()), quoted(entryPoint.string())));
    if (isDone && isRegularFile(output)) {
        const std::string bytes = readTextFile(output);
        shader.words.resize(bytes.size() / sizeof(uint32_t));
        std::memcpy(shader.words.data(), bytes.data(), shader.words.size() * sizeof(uint32_t));
    } else {
        shader.problem = text.empty() ? "glslangValidator failed" : firstError(text);
    }
    std::error_code ignored;
    fs::remove(output, ignored);
    return shader;
}

}  // namespace manylight
