// SPDX-License-Identifier: MIT
#include <tests/TestData.h>
#include <tests/tool/Tool.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <tuple>

namespace {

const std::string head = "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 10\n";

/// Two hours of wind in WindNinja's format: 4 m/s, then 8 m/s from the west.
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

TEST_F(WindTool, PrintsTheSummaryOfAFile) {
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

TEST_F(WindTool, PrintsTheWindAtAPlaceAndTime) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"1_vel.asc", "2_vel.asc", "--times", "0,3600", "--at", "5,5,10", "--time",
                                   "900"},
          {"--times", "0,3600", "--at", "5,5,10", "--time", "900", "1_vel.asc", "2_vel.asc"}}) {
        const Outcome outcome = wind(words);
        EXPECT_EQ(outcome.exitCode, 0);
        EXPECT_EQ(outcome.out.rfind("5, ", 0), 0u) << outcome.out;
        EXPECT_EQ(outcome.err, "1_vel.asc: note: the file gives no unit of speed; m/s is assumed\n");
    }
}

TEST_F(WindTool, RefusesInvalidCombinations) {
    for (const auto& [words, message] :
         {std::pair<std::vector<std::string>, const char*>{
              {"1_vel.asc", "2_vel.asc"}, "times: expected one time for each file, because 1_vel.asc"},
          {{"1_vel.asc", "2_vel.asc", "--times", "0"},
           "times: expected 2 numbers, one for each file, found 1"},
          {{"1_vel.asc", "2_vel.asc", "--times", "7,7"}, "times: expected increasing seconds"},
          {{"1_vel.asc", "2_vel.asc", "--times", "0,x"}, "--times"},
          {{"1_vel.asc", "wide_vel.asc", "--times", "0,1"}, "wide_vel.asc: expected the points"},
          {{"1_vel.asc", "absent.asc", "--times", "0,1"}, "absent.asc: no such file"},
          {{"1_vel.asc", "--at", "nan,5,10"}, "--at"},
          {{"1_vel.asc", "--at", "5,inf,10"}, "--at"},
          {{"1_vel.asc", "--at", "5,5,10", "--time", "nan"}, "--time: expected seconds"},
          {{"1_vel.asc", "--at", "5,5,10", "--time", "2017-10-26T15:00Z"}, "found 2017-10-26T15:00Z"},
          {{"1_vel.asc", "--time", "5"}, "--time requires --at"},
          {{"1_vel.asc", "--at", "5,5,10", "--crs", "EPSG:4326"}, "crs: expected a projected system"},
          {{}, "file is required"}}) {
        const Outcome outcome = wind(words);
        EXPECT_EQ(outcome.exitCode, 2) << message;
        EXPECT_EQ(outcome.out, "");
        EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    }
}

/// Prints speed and direction as in the file, with a note that a forest turns them.
TEST_F(WindTool, PrintsVelocitiesAsTheFileHasThem) {
    REQUIRE_REAL_DATA(path, "wind/ndfd_20170603T1800.nc");
    for (const auto& [place, speed, degrees] : {std::tuple{"-1640665.53,2052449.95,10", 4.4375, 154.0},
                                                {"-1432411.62,2319122.07,10", 4.25, 183.0}}) {
        const Outcome outcome = wind({path, "--at", place}), json = wind({path, "--at", place, "--json"});
        if (outcome.err.find("NetCDF needs GDAL") != std::string::npos)
            GTEST_SKIP() << "built without GDAL";
        EXPECT_NE(outcome.err.find("in a forest they are turned to the grid's y axis"), std::string::npos);
        const auto said = nlohmann::json::parse(json.out, nullptr, false);
        ASSERT_FALSE(said.is_discarded()) << json.out;
        const double angle = degrees * 3.14159265358979323846 / 180.0;
        EXPECT_NEAR(said["velocity"][0], -speed * std::sin(angle), 2e-3);
        EXPECT_NEAR(said["velocity"][1], -speed * std::cos(angle), 2e-3);
        EXPECT_NE(said["notes"][0].get<std::string>().find("true north"), std::string::npos);
    }
}
