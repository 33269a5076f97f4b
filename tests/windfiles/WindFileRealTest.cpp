// SPDX-License-Identifier: MIT
// Real files compared with a plain reading of their text.
#include <osgTreeWind/windfiles/WindFile.h>

#include <glm/gtc/constants.hpp>

#include <tests/Near.h>
#include <tests/TestData.h>
#include <tests/base/FirstProblem.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <vector>

namespace osgTreeWind {

namespace {

WindFile readReal(const std::string& path, const glm::dvec3& origin = glm::dvec3(0.0)) {
    WindFileOptions options;
    options.origin = origin;
    const Result<WindFile> file = readWindFile(path, options);
    EXPECT_TRUE(file) << firstProblem(file);
    return file ? file.value() : WindFile{};
}

std::vector<std::string> readLines(const std::string& path) {
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);)
        lines.push_back(line);
    return lines;
}

/// The number in a row (from the north, 0 the first below the header) and column of an ESRI grid.
double cellOf(const std::string& path, int row, int column) {
    std::istringstream line(readLines(path)[static_cast<std::size_t>(6 + row)]);
    double value = 0.0;
    for (int i = 0; i <= column; ++i)
        line >> value;
    return value;
}

} // namespace

class WindNinjaGrids : public testing::TestWithParam<const char*> {};

TEST_P(WindNinjaGrids, MatchTheTextAtTheirCells) {
    const std::string name = "wind/windninja_pig/" + std::string(GetParam());
    REQUIRE_REAL_DATA(speeds, name + "_vel.asc");
    REQUIRE_REAL_DATA(directions, name + "_ang.asc");
    const std::vector<std::string> lines = readLines(speeds);
    double header[5];
    for (std::size_t i = 0; i < 5; ++i) {
        std::string key;
        std::istringstream(lines[i]) >> key >> header[i];
    }
    const auto [columns, rows, x, y, cell] = header;
    for (int row : {0, 1, 4, static_cast<int>(rows) - 1})
        for (int column : {0, 5, static_cast<int>(columns) - 1}) {
            const double s = cellOf(speeds, row, column),
                         d = cellOf(directions, row, column) * glm::pi<double>() / 180.0;
            const glm::dvec3 place(x + (column + 0.5) * cell, y + (rows - row - 0.5) * cell, 0.0);
            const WindFile file = readReal(speeds, place);
            ASSERT_TRUE(file.wind.field);
            expectNear(asField(file.wind)->velocity({0, 0, 10}, 0), {-s * std::sin(d), -s * std::cos(d), 0},
                       1e-5f);
            EXPECT_NE(file.summary.coordinates.find("Antarctic"), std::string::npos);
        }
}

INSTANTIATE_TEST_SUITE_P(Pig, WindNinjaGrids,
                         testing::Values("198001010100/input/198001010100", "198001010100/output/PIG_1000m",
                                         "198001010200/input/198001010200", "198001010200/output/PIG_1000m"),
                         [](const auto& info) {
                             return "hour" + std::to_string(info.index / 2 + 1) +
                                    (info.index % 2 ? "output" : "input");
                         });

/// Half way between two hours, the mean of their components.
TEST(WindFileReal, ReadsTwoHoursOfWindNinjaAsOneWind) {
    const std::string folder = "wind/windninja_pig/";
    REQUIRE_REAL_DATA(first, folder + "198001010100/output/PIG_1000m_vel.asc");
    REQUIRE_REAL_DATA(second, folder + "198001010200/output/PIG_1000m_vel.asc");
    REQUIRE_REAL_DATA(firstAngles, folder + "198001010100/output/PIG_1000m_ang.asc");
    REQUIRE_REAL_DATA(secondAngles, folder + "198001010200/output/PIG_1000m_ang.asc");
    const auto velocity = [](double speed, double degrees) {
        return -speed * glm::dvec3(std::sin(degrees * glm::pi<double>() / 180.0),
                                   std::cos(degrees * glm::pi<double>() / 180.0), 0.0);
    };
    for (int row : {0, 50, 97})
        for (int column : {0, 70, 137}) {
            WindFileOptions options;
            options.origin = {-1540000.0 + 1000.0 * column, -12000.0 - 1000.0 * row, 0.0};
            const auto wind = readWindFiles({first, second}, {0.0, 3600.0}, options);
            ASSERT_TRUE(wind) << firstProblem(wind);
            const glm::dvec3 v1 = velocity(cellOf(first, row, column), cellOf(firstAngles, row, column)),
                             v2 = velocity(cellOf(second, row, column), cellOf(secondAngles, row, column));
            EXPECT_GT(glm::length(v2 - v1), 0.01) << "the hours differ";
            for (double part : {0.0, 0.25, 0.5, 1.0})
                expectNear(asField(wind.value().wind)->velocity({0, 0, 10}, 3600.0 * part),
                           glm::vec3(v1 + part * (v2 - v1)), 1e-5f);
        }
}

TEST(WindFileReal, LargeEddyMeanMatchesItsText) {
    REQUIRE_REAL_DATA(path, "wind/array.mean0D_UAvg.vtk");
    const WindFile file = readReal(path, {758, 660.001, 10.001});
    ASSERT_TRUE(file.wind.field);
    EXPECT_EQ(file.summary.points, glm::ivec3(99, 39, 16));
    const std::vector<std::string> lines = readLines(path);
    for (const glm::ivec3 point : {glm::ivec3(0), glm::ivec3(98, 38, 15), glm::ivec3(50, 7, 3)}) {
        const int at = 10 + point.x + 99 * (point.y + 39 * point.z);
        glm::vec3 expected;
        std::istringstream(lines[static_cast<std::size_t>(at)]) >> expected.x >> expected.y >> expected.z;
        expectNear(asField(file.wind)->velocity(glm::vec3(point) * 10.0f, 0), expected, 1e-5f);
    }
}

TEST(WindFileReal, TurbSimMatchesItsBytes) {
    REQUIRE_REAL_DATA(path, "wind/TurbSim_WithTwr.bts");
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const auto number = [&](std::size_t at, auto value) {
        std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), sizeof value,
                    reinterpret_cast<char*>(&value));
        return value;
    };
    const int nz = number(2, std::int32_t()), ny = number(6, std::int32_t()),
              tower = number(10, std::int32_t());
    const float dz = number(18, 0.0f), dy = number(22, 0.0f), dt = number(26, 0.0f),
                bottom = number(38, 0.0f);
    const auto data = static_cast<std::size_t>(70 + number(66, std::int32_t()));
    const WindFile wind = readReal(path);
    ASSERT_TRUE(wind.wind.field);
    EXPECT_EQ(wind.summary.points, glm::ivec3(1, ny, nz));
    for (const glm::ivec3 at :
         {glm::ivec3(0, 0, 0), glm::ivec3(99, 2, 3), glm::ivec3(37, 1, 2)}) { // time, y, z
        glm::vec3 expected;
        for (int c = 0; c < 3; ++c) {
            const int index = at.x * 3 * (ny * nz + tower) + c + 3 * (at.y + ny * at.z);
            const float raw = number(data + 2 * static_cast<std::size_t>(index), std::int16_t());
            const std::size_t scale = 42 + 8 * static_cast<std::size_t>(c);
            expected[c] = (raw - number(scale + 4, 0.0f)) / number(scale, 0.0f);
        }
        const glm::vec3 place(0, dy * (at.y - 0.5f * (ny - 1)), bottom + dz * at.z);
        expectNear(asField(wind.wind)->velocity(place, at.x * static_cast<double>(dt)), expected, 2e-4f);
    }
}

TEST(WindFileReal, SonicRecordMatchesItsText) {
    REQUIRE_REAL_DATA(path, "wind/TOA5_6843.ts_Above_2012_06_07_1245.dat");
    const std::vector<std::string> lines = readLines(path);
    const WindFile file = readReal(path);
    ASSERT_TRUE(file.wind.field);
    ASSERT_EQ(file.summary.times.size(), lines.size() - 4);
    for (std::size_t i : {std::size_t(0), std::size_t(1), std::size_t(777), lines.size() - 5}) {
        std::istringstream cells(lines[i + 4]);
        std::string ignored;
        std::getline(cells, ignored, ',');
        std::getline(cells, ignored, ',');
        glm::vec3 expected;
        char comma;
        cells >> expected.x >> comma >> expected.y >> comma >> expected.z;
        EXPECT_NEAR(file.summary.times[i], 0.05 * static_cast<double>(i), 1e-6);
        expectNear(asField(file.wind)->velocity({}, file.summary.times[i]), expected, 1e-5f);
    }
}

TEST(WindFileReal, QesSensorIsRecognised) {
    REQUIRE_REAL_DATA(path, "utah_campus/sensor2015.xml");
    const WindFile file = readReal(path);
    EXPECT_EQ(file.summary.format, "QES-Winds sensor");
    EXPECT_EQ(file.summary.times.size(), 384u);
}

/// The first three records, and half way from the first to the second, at the height of the measurement.
TEST(WindFileReal, QesSensorMatchesItsText) {
    REQUIRE_REAL_DATA(path, "utah_campus/sensor2015.xml");
    const WindFile file = readReal(path);
    ASSERT_TRUE(file.wind.field);
    const auto velocity = [](double speed, double from) {
        return glm::vec3(-speed * std::sin(from * glm::pi<double>() / 180.0),
                         -speed * std::cos(from * glm::pi<double>() / 180.0), 0.0);
    };
    const glm::vec3 first = velocity(3.1, 78.4), second = velocity(2.9, 107.0);
    const auto at = [&](float height, double time) {
        return asField(file.wind)->velocity({300, -20, height}, time);
    };
    expectNear(at(42, 0), first, 1e-5f);
    expectNear(at(42, 1800), second, 1e-5f);
    expectNear(at(42, 900), 0.5f * (first + second), 1e-5f);
    expectNear(at(42, 3600), velocity(2.5, 143.8), 1e-5f);
    expectNear(at(10, 0), first * static_cast<float>(std::log(10 / 0.1) / std::log(42 / 0.1)), 1e-5f);
}

} // namespace osgTreeWind
