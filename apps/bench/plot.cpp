#include "apps/bench/plot.h"

#include "engine/core/error.h"
#include "engine/core/file.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cstdlib>
#include <cstring>
#include <system_error>

extern char** environ;

namespace manylight {
namespace {

namespace fs = std::filesystem;

std::string interpreter() {
    const char* chosen = std::getenv("MANYLIGHT_PYTHON");
    if (chosen != nullptr && *chosen != '\0') return chosen;
    // The system's own first: the distribution's matplotlib belongs to it.
    return fs::exists("/usr/bin/python3") ? "/usr/bin/python3" : "python3";
}

/// Beside the installed program, or else in the source tree that it was built from.
fs::path findScript(const std::string& script) {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    const fs::path installed = program.parent_path().parent_path() / "share/manylight" / script;
    return fs::exists(installed, ignored) ? installed : fs::path(MANYLIGHT_SOURCE_DIR) / "scripts" / script;
}

/// Runs `program` with `arguments` and waits for it; throws Error unless it exits with 0.
void runProcess(const std::string& program, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), program);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    pid_t child = 0;
    if (const int error = ::posix_spawnp(&child, program.c_str(), nullptr, nullptr, argv.data(), environ); error != 0)
        fail("cannot run {}: {}", program, std::strerror(error));
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) fail("cannot wait for {}: {}", program, std::strerror(errno));
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) fail("{} failed", program);
}

/// A file that goes when the scope ends.
class TemporaryFile {
  public:
    explicit TemporaryFile(fs::path path) : path_(std::move(path)) {}
    ~TemporaryFile() {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

}  // namespace

void checkPlotFile(const std::string& picture) {
    if (picture.empty()) return;
    if (!picture.ends_with(".png") && !picture.ends_with(".svg"))
        failUsage("--plot {}: expected a file name that ends in .png or .svg", picture);
    requireWritable(picture);
}

bool drawPlot(const std::string& script, const Json& data, const fs::path& picture) {
    try {
        writeAtomically(picture, [&](const fs::path& temporary) {
            const TemporaryFile input(temporary.string() + ".json");
            writeTextFile(input.path(), data.dump());
            runProcess(interpreter(), {findScript(script).string(), input.path().string(), temporary.string()});
        });
        return true;
    } catch (const Error& error) {
        fmt::print(stderr, "warning: {} not drawn: {}\n", picture.string(), error.what());
        return false;
    }
}

}  // namespace manylight
