#include "apps/view_model/window_tiles.h"

#include <gtest/gtest.h>

namespace manylight::test {
namespace {

constexpr glm::uvec2 kCanvas{24, 18};

bool contains(const PixelRect& rect, glm::ivec2 pixel) {
    return glm::all(glm::greaterThanEqual(pixel, rect.low)) && glm::all(glm::lessThan(pixel, rect.high));
}

/// Every pixel is in one tile, and those of panels in one that has panels. Returns the pixels of tiles with panels.
int expectTiles(const std::vector<PixelRect>& panels) {
    const std::vector<WindowTile> tiles = tileWindow(kCanvas, panels);
    int withPanels = 0;
    for (int y = 0; y < static_cast<int>(kCanvas.y); ++y) {
        for (int x = 0; x < static_cast<int>(kCanvas.x); ++x) {
            const glm::ivec2 pixel(x, y);
            int tilesHere = 0;
            bool hasPanels = false;
            for (const WindowTile& tile : tiles) {
                if (!contains(tile.rect, pixel)) continue;
                ++tilesHere;
                hasPanels = tile.hasPanels;
            }
            EXPECT_EQ(tilesHere, 1) << x << ", " << y;
            for (const PixelRect& panel : panels) EXPECT_TRUE(hasPanels || !contains(panel, pixel)) << x << ", " << y;
            withPanels += hasPanels ? 1 : 0;
        }
    }
    return withPanels;
}

TEST(WindowTiles, NoPanelsLeaveOneTile) {
    EXPECT_EQ(tileWindow(kCanvas, {}).size(), 1u);
    EXPECT_EQ(expectTiles({}), 0);
}

TEST(WindowTiles, PanelsSideBySideCostTheirOwnAreas) {
    EXPECT_EQ(expectTiles({{{1, 2}, {7, 15}}, {{15, 3}, {23, 9}}}), 6 * 13 + 8 * 6);
}

TEST(WindowTiles, PanelsThatOverlapOrTouchAreCoveredOnce) {
    expectTiles({{{1, 2}, {12, 9}}, {{8, 5}, {20, 17}}});
    expectTiles({{{0, 0}, {8, 4}}, {{0, 4}, {8, 9}}, {{8, 0}, {9, 18}}});
    expectTiles({{{2, 2}, {20, 16}}, {{5, 5}, {9, 9}}});
}

TEST(WindowTiles, PanelsBeyondTheWindowAreCutOff) {
    EXPECT_EQ(expectTiles({{{-5, -5}, {4, 3}}, {{20, 10}, {99, 99}}}), 4 * 3 + 4 * 8);
    EXPECT_EQ(expectTiles({{{-9, 0}, {-2, 18}}, {{24, 0}, {30, 18}}, {{5, 5}, {5, 9}}}), 0);
    EXPECT_EQ(expectTiles({{{-1, -1}, {99, 99}}}), 24 * 18);
}

}  // namespace
}  // namespace manylight::test
