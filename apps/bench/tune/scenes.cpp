#include "apps/bench/tune/scenes.h"

#include "engine/core/error.h"
#include "engine/scene/generate/cornell_box.h"
#include "engine/scene/generate/courtyard.h"
#include "engine/scene/import.h"

#include <cstdlib>

namespace manylight {
namespace {

namespace fs = std::filesystem;

/// Gone with all that is in it.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        const std::string random(6, 'X');  // what mkdtemp replaces
        std::string name = (fs::temp_directory_path() / ("manylight-tune-" + random)).string();
        if (!mkdtemp(name.data())) fail("{}: cannot create a folder", name);
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

Scene importGenerated(const GeneratedScene& generated, const fs::path& folder) {
    writeGeneratedScene(generated, folder);
    return importScene(folder / (generated.name + ".json"));
}

}  // namespace

std::vector<Scene> scenesOf(const TuneOptions& options) {
    std::vector<Scene> scenes;
    for (const fs::path& file : options.scenes) scenes.push_back(importScene(file));
    if (!scenes.empty()) return scenes;
    const TemporaryFolder folder;
    scenes.push_back(importGenerated(generateCornellBox(), folder.path()));
    scenes.push_back(importGenerated(generateCourtyard({}), folder.path()));
    return scenes;
}

}  // namespace manylight
