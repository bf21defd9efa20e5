// Reviewed text snapshots in tests/graphs: a mismatch prints both texts; MANYLIGHT_UPDATE_SNAPSHOTS=1 rewrites them.
#pragma once

#include "engine/core/file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

namespace manylight {

inline void expectSnapshot(const std::string& name, const std::string& text) {
    const std::filesystem::path file =
        std::filesystem::path(MANYLIGHT_SOURCE_DIR) / "tests" / "graphs" / (name + ".txt");
    const char* update = std::getenv("MANYLIGHT_UPDATE_SNAPSHOTS");
    if (update != nullptr && std::string_view(update) == "1") {
        writeTextFile(file, text);
        return;
    }
    const std::string reviewed = std::filesystem::exists(file) ? readTextFile(file) : "(there is no such file)\n";
    EXPECT_TRUE(text == reviewed) << file << "\n--- reviewed\n"
                                  << reviewed << "--- now\n"
                                  << text << "--- if that is right, run again with MANYLIGHT_UPDATE_SNAPSHOTS=1";
}

}  // namespace manylight
