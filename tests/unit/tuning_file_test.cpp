// The file of tunings: what is written is read again, by its device alone, and damage ends in the default.
#include "engine/gpu/tuning_file.h"
#include "engine/core/file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace manylight::gpu {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class TuningFile : public ::testing::Test {
  protected:
    TuningFile() { fs::remove_all(folder_); }
    ~TuningFile() override { fs::remove_all(folder_); }

    /// Of the first device.
    std::optional<Tuning> read() { return readTuning(file_, first_, warnings_); }
    void write(const std::string& text) {
        fs::create_directories(file_.parent_path());
        writeTextFile(file_, text);
    }

    const TuningKey first_{"A GPU", "its driver 1.2", 0x10de, 0x2330, 77};
    const fs::path folder_ =
        fs::path(::testing::TempDir()) /
        fmt::format("manylight_tuning_{}", ::testing::UnitTest::GetInstance()->current_test_info()->name());
    const fs::path file_ = folder_ / "cache" / "tuning.json";
    Warnings warnings_;
};

/// Of every tunable the value after the default.
Tuning otherTuning() {
    Tuning tuning;
    for (const Tunable& tunable : tunables()) tunable.of(tuning) = tunable.values.at(1);
    return tuning;
}

/// The default but for some numbers.
Tuning tuningWith(const std::vector<std::pair<uint32_t Tuning::*, uint32_t>>& numbers) {
    Tuning tuning;
    for (const auto& [number, value] : numbers) tuning.*number = value;
    return tuning;
}

TEST_F(TuningFile, TheDefaultIsTheFirstValueOfEveryTunable) {
    Tuning fromTable = otherTuning();
    for (const Tunable& tunable : tunables()) tunable.of(fromTable) = tunable.values.at(0);
    EXPECT_EQ(fromTable, Tuning{});
    constexpr size_t kFollowsFromScene = 1;  // closestRegisters
    EXPECT_EQ((tunables().size() + kFollowsFromScene) * sizeof(uint32_t), sizeof(Tuning))
        << "a number that no tunable is about";
}

TEST_F(TuningFile, WhatIsWrittenIsReadAgainByItsDeviceAlone) {
    EXPECT_EQ(read(), std::nullopt);
    writeTuning(file_, first_, otherTuning());
    EXPECT_EQ(read(), otherTuning());
    TuningKey newDriver = first_;
    newDriver.driverVersion = 78;
    EXPECT_EQ(readTuning(file_, newDriver, warnings_), std::nullopt);

    Tuning second = otherTuning();
    second.rayThreads = 64;
    writeTuning(file_, newDriver, second);
    EXPECT_EQ(read(), otherTuning());
    EXPECT_EQ(readTuning(file_, newDriver, warnings_), second);
    writeTuning(file_, first_, second);
    EXPECT_EQ(read(), second);
    writeTuning(file_, first_, std::nullopt);
    EXPECT_EQ(read(), std::nullopt);
    EXPECT_EQ(readTuning(file_, newDriver, warnings_), second);
    EXPECT_TRUE(warnings_.empty()) << warnings_.toText();
}

TEST_F(TuningFile, WhatIsNotThereIsTheDefault) {
    writeTuning(file_, first_, otherTuning());
    Json json = Json::parse(readTextFile(file_));
    json["devices"][0]["tuning"] = {{"ray-threads", 64}};
    write(json.dump());
    EXPECT_EQ(read(), tuningWith({{&Tuning::rayThreads, 64}}));
    EXPECT_TRUE(warnings_.empty()) << warnings_.toText();
}

TEST_F(TuningFile, DamageIsAWarningAndReplaced) {
    writeTuning(file_, first_, otherTuning());
    const std::string whole = readTextFile(file_);
    const auto with = [&](const char* name, const Json& value) {
        Json json = Json::parse(whole);
        json["devices"][0]["tuning"][name] = value;
        return json.dump();
    };
    uint64_t damaged = 0;
    for (const std::string& text :
         {std::string(), std::string("no JSON"), std::string("[]"), std::string("{}"),
          whole.substr(0, whole.size() / 2), std::string(R"({"manylight_tuning": 2, "devices": []})"),
          std::string(R"({"manylight_tuning": 1, "devices": [{"key": 5}]})"),
          std::string(R"({"manylight_tuning": 1, "devices": 7})"), with("ray-threads", 65), with("ray-threads", -128),
          with("ray-threads", 4294967424u), with("ray-threads", "128"), with("ray-threads", nullptr),
          with("image-width", 16.0), with("nobody knows", 1)}) {
        write(text);
        EXPECT_EQ(read(), std::nullopt) << text;
        EXPECT_EQ(warnings_.total(), ++damaged) << text;
    }
    EXPECT_THAT(warnings_.toText(), HasSubstr("tuning files not understood"));
    write("no JSON");
    writeTuning(file_, first_, otherTuning());
    EXPECT_EQ(read(), otherTuning());
}

TEST_F(TuningFile, ADeviceIsAskedForNoMoreThanItHas) {
    const GroupLimits small{128, 128, 64, 8};
    EXPECT_TRUE(fits({}, small));
    EXPECT_FALSE(fits(tuningWith({{&Tuning::gatherThreads, 256}}), small));
    EXPECT_FALSE(fits(tuningWith({{&Tuning::rayThreads, 256}}), small));
    EXPECT_FALSE(fits(tuningWith({{&Tuning::pathThreads, 256}}), small));
    EXPECT_FALSE(fits(tuningWith({{&Tuning::imageWidth, 32}}), small));
    EXPECT_TRUE(fits(tuningWith({{&Tuning::imageWidth, 32}, {&Tuning::imageHeight, 4}}), small));
    EXPECT_FALSE(fits(tuningWith({{&Tuning::rayThreads, 96}}), small)) << "no value of the tunable";
    EXPECT_FALSE(fits(tuningWith({{&Tuning::rayThreads, 32}}), {1024, 1024, 1024, 64})) << "less than a subgroup";
    EXPECT_FALSE(fits(tuningWith({{&Tuning::imageHeight, 16}}), {1024, 1024, 8, 32}));
}

TEST_F(TuningFile, TheEnvironmentNamesIt) {
    const char* before = std::getenv("MANYLIGHT_TUNING");
    const std::string kept = before != nullptr ? before : "";
    setenv("MANYLIGHT_TUNING", "off", 1);
    EXPECT_EQ(tuningFile(), std::nullopt);
    setenv("MANYLIGHT_TUNING", "mine.json", 1);
    EXPECT_EQ(tuningFile(), fs::path("mine.json"));
    setenv("MANYLIGHT_TUNING", kept.c_str(), 1);
}

}  // namespace
}  // namespace manylight::gpu
