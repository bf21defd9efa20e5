// Runs the viewer by scripts on a display without a screen.
#pragma once

#include "engine/core/file.h"
#include "engine/core/report.h"
#include "engine/image/image_io.h"
#include "tests/unit/import_test_support.h"

#include <sys/wait.h>

#include <cstdlib>

namespace manylight::test {

inline constexpr uint32_t kWidth = 96;  // pixels of the window
inline constexpr uint32_t kHeight = 64;

class ViewerTest : public testing::SceneFiles {
  protected:
    std::string scene_ = std::string(MANYLIGHT_SOURCE_DIR) + "/scenes/cornell_box.json";

    std::string program(const std::string& name) const {
        return std::string(MANYLIGHT_BINARY_DIR) + "/bin/manylight-" + name;
    }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string textOf(const std::string& name) const { return readTextFile(folder_ / name); }
    Json jsonOf(const std::string& name) const { return Json::parse(textOf(name)); }
    EncodedImage imageOf(const std::string& name) const { return readImage8(folder_ / name); }

    std::string environment_;  // variables for the programs, as a shell sets them

    /// Exit code; what it prints goes to the file "output".
    int run(const std::string& command) const {
        const std::string whole = fmt::format("cd '{}' && {} MANYLIGHT_VALIDATION=sync timeout 120 {} >output 2>&1",
                                              folder_.string(), environment_, command);
        const int status = std::system(whole.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    /// Runs the viewer in the test's folder, where the script's files are too; no validation message may come.
    void view(const std::string& script, const std::string& options = "") const {
        write("script.txt", script + "\nreport end.json\nquit\n");
        const std::string command =
            fmt::format("xvfb-run -a {} {} --size {}x{} --bounces 2 --light-samples 4 {} --script script.txt",
                        program("view"), scene_, kWidth, kHeight, options);
        ASSERT_EQ(run(command), 0) << textOf("output");
        EXPECT_EQ(jsonOf("end.json")["validation_messages"], 0) << textOf("output");
    }
};

/// Of two pictures of one size; -1 if they have two.
inline int largestDifference(const EncodedImage& a, const EncodedImage& b) {
    if (a.width != b.width || a.height != b.height) return -1;
    int largest = 0;
    for (size_t i = 0; i < a.rgba.size(); ++i) largest = std::max(largest, std::abs(int{a.rgba[i]} - int{b.rgba[i]}));
    return largest;
}

}  // namespace manylight::test
