// The table of FPS in the window.
#include "tests/view/view_test.h"

#include <set>

namespace manylight::test {
namespace {

using ViewerFps = ViewerTest;

TEST_F(ViewerFps, HasARowForEveryCountAndLeavesThePictureAsItWas) {
    view(
        "set panel off\nset interleave 2\nframes 2\ncapture before.png\nfps-table 8 2\nreport table.json\nframes 2\n"
        "capture after.png\nset panel on\nwait 2\nscreenshot panel.png\nclick 79 40\nwait 1\nreport closed.json\n"
        "screenshot closed.png",
        "--vpls 12");
    const Json table = jsonOf("table.json")["fps_table"];
    ASSERT_EQ(table.size(), 6u);
    std::set<std::pair<std::string, int>> seen;
    for (const Json& row : table) {
        seen.emplace(row["technique"].get<std::string>(), row["vpls"].get<int>());
        EXPECT_EQ(row["frames"], 6);
        EXPECT_EQ(row["shadows"], true);
        EXPECT_GT(row["milliseconds"], 0.0);
        EXPECT_NEAR(row["fps"].get<double>() * row["milliseconds"].get<double>(), 1000.0, 1e-6);
    }
    EXPECT_EQ(table[0]["vpls"], 2) << "in order";
    EXPECT_FALSE(jsonOf("closed.json").contains("fps_table")) << "the button in its corner closes it";
    EXPECT_EQ(seen.size(), 6u);
    EXPECT_EQ(jsonOf("end.json")["settings"]["technique"], "deferred");
    EXPECT_EQ(jsonOf("end.json")["settings"]["interleave"], 2);
    EXPECT_EQ(largestDifference(imageOf("before.png"), imageOf("after.png")), 0);
}

}  // namespace
}  // namespace manylight::test
