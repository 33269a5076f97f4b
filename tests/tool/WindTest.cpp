// SPDX-License-Identifier: MIT
#include "../TestData.h"
#include "Tool.h"

#include <nlohmann/json.hpp>

namespace {

const std::string head = "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 10\n";

/// Two hours of WindNinja's kind: 4, then 8 m/s from west.
class WindTool : public testing::Test {
protected:
    const TemporaryFolder folder;

    void SetUp() override {
        for (const std::string hour : {"1", "2"}) {
            folder.write(hour + "_vel.asc", head + (hour == "1" ? "4 4\n" : "8 8\n"));
            folder.write(hour + "_ang.asc", head + "270 270\n");
        }
        folder.write("wide_vel.asc", "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 10\n4\n");
        folder.write("wide_ang.asc", "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 10\n4\n");
    }

    Outcome wind(std::vector<std::string> words) const {
        words.insert(words.begin(), "wind");
        return runTool(words, folder.path());
    }
};

} // namespace

TEST_F(WindTool, ShowsWhatAFileSays) {
    const Outcome outcome = wind({"1_vel.asc"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.err, "");
    for (const char* text : {"ESRI ASCII speed and direction", "2 east, 1 north, 1 up",
                             "from, degrees clockwise from grid north", "4 to 4 m/s"})
        EXPECT_NE(outcome.out.find(text), std::string::npos) << outcome.out;
}

TEST_F(WindTool, JoinsSeveralFilesAtTheirTimes) {
    const Outcome outcome = wind({"1_vel.asc", "2_vel.asc", "--times", "0,3600", "--json"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto summary = nlohmann::json::parse(outcome.out, nullptr, false);
    ASSERT_FALSE(summary.is_discarded()) << outcome.out;
    EXPECT_EQ(summary["times"]["count"], 2);
    EXPECT_EQ(summary["times"]["last"], 3600.0);
    EXPECT_EQ(summary["speed"]["fastest"], 8.0);
}

TEST_F(WindTool, TellsTheWindAtAPlaceAndTime) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"1_vel.asc", "2_vel.asc", "--times", "0,3600", "--at", "5,5,10,900"},
          {"--times", "0,3600", "--at", "5,5,10,900", "1_vel.asc", "2_vel.asc"}}) {
        const Outcome outcome = wind(words);
        EXPECT_EQ(outcome.exitCode, 0);
        EXPECT_EQ(outcome.out.rfind("5, ", 0), 0u) << outcome.out;
        EXPECT_EQ(outcome.err, "1_vel.asc: note: the file names no unit of speed; taken as m/s\n");
    }
}

TEST_F(WindTool, RefusesWhatDoesNotGoTogether) {
    for (const auto& [words, message] :
         {std::pair<std::vector<std::string>, const char*>{
              {"1_vel.asc", "2_vel.asc"}, "times: expected 2 numbers, one for each file, found 0"},
          {{"1_vel.asc", "2_vel.asc", "--times", "0"},
           "times: expected 2 numbers, one for each file, found 1"},
          {{"1_vel.asc", "2_vel.asc", "--times", "7,7"}, "times: expected increasing seconds"},
          {{"1_vel.asc", "2_vel.asc", "--times", "0,x"}, "--times"},
          {{"1_vel.asc", "wide_vel.asc", "--times", "0,1"}, "wide_vel.asc: expected the points"},
          {{"1_vel.asc", "absent.asc", "--times", "0,1"}, "absent.asc: cannot be read"},
          {{}, "file is required"}}) {
        const Outcome outcome = wind(words);
        EXPECT_EQ(outcome.exitCode, 2) << message;
        EXPECT_EQ(outcome.out, "");
        EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    }
}

/// A velocity that is not the speed and direction in the file comes with the reason.
TEST_F(WindTool, SaysThatItTurnsTrueNorth) {
    REQUIRE_REAL_DATA(path, "wind/ndfd_20170603T1800.nc");
    const std::string place = "-1640665.53,2052449.95,10"; // the file has 4.4375 m/s from 154 degrees
    const Outcome outcome = wind({path, "--at", place}), json = wind({path, "--at", place, "--json"});
    if (outcome.err.find("NetCDF needs GDAL") != std::string::npos)
        GTEST_SKIP() << "built without GDAL";
    EXPECT_NE(outcome.err.find("velocities here are turned to the grid's y axis"), std::string::npos);
    const auto said = nlohmann::json::parse(json.out, nullptr, false);
    ASSERT_FALSE(said.is_discarded()) << json.out;
    EXPECT_NEAR(said["speed"], 4.4375, 1e-3);
    EXPECT_NE(said["notes"][0].get<std::string>().find("true north"), std::string::npos);
}
