// SPDX-License-Identifier: MIT
#include <tests/TestData.h>
#include <tests/base/FirstProblem.h>
#include <tests/windfiles/RecordOf.h>

#include <osgTreeWind/wind/WindDirection.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <regex>
#include <sstream>

using namespace osgTreeWind;

namespace {

Result<WindSeries> read(const std::string& content) {
    return recordOf(readQesSensor(content, "s.xml"));
}

std::string record(const std::string& time, const std::string& speed, const std::string& direction,
                   const std::string& rest = "<height> 10 </height>\n<siteZ0> 0.1 </siteZ0>\n") {
    return "<timeSeries>\n<timeEpoch> " + time + " </timeEpoch>\n" + rest + "<speed> " + speed +
           " </speed>\n<direction> " + direction + " </direction>\n</timeSeries>\n";
}

std::string fileText(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// All numbers between <name> and </name>, found without an XML parser.
std::vector<double> numbersIn(const std::string& text, const std::string& name) {
    const std::regex element("<" + name + ">([^<]*)</");
    std::vector<double> numbers;
    for (std::sregex_iterator i(text.begin(), text.end(), element), end; i != end; ++i)
        numbers.push_back(std::stod((*i)[1]));
    return numbers;
}

} // namespace

TEST(QesSensor, ReadsFragmentsWithoutARoot) {
    const auto series = read("<site_UTM_x> 428456 </site_UTM_x>\n" + record("1000", "5", "270") +
                             "<!-- a comment -->\n" + record("2800", "2", "180"));
    ASSERT_TRUE(series) << firstProblem(series);
    EXPECT_EQ(series.value().times, (std::vector<double>{0, 1800}));
    EXPECT_NEAR(series.value().velocities[0].x, 5.0f, 1e-5f);
    EXPECT_NEAR(series.value().velocities[1].y, 2.0f, 1e-5f);
    ASSERT_TRUE(series.value().profile);
    EXPECT_EQ(series.value().profile->height, 10.0);
    EXPECT_EQ(series.value().profile->roughness, 0.1);
}

TEST(QesSensor, ReadsRecordsWithinARoot) {
    const auto series =
        read("<?xml version=\"1.0\"?><sensor>" + record("0", "1", "0") + record("1", "2", "0") + "</sensor>");
    ASSERT_TRUE(series) << firstProblem(series);
    EXPECT_NEAR(series.value().velocities[1].y, -2.0f, 1e-6f);
}

namespace {

struct BadSensor {
    const char* name;
    std::string content;
    const char* problem;
};

void PrintTo(const BadSensor& bad, std::ostream* out) {
    *out << bad.name;
}

} // namespace

class QesSensorRefuses : public testing::TestWithParam<BadSensor> {};

TEST_P(QesSensorRefuses, WithPlaceAndReason) {
    EXPECT_EQ(firstProblem(read(GetParam().content)), GetParam().problem);
}

INSTANTIATE_TEST_SUITE_P(
    Sensor, QesSensorRefuses,
    testing::Values(
        BadSensor{"Empty", "", "s.xml: the file is empty"},
        BadSensor{"NoRecord", "<site_UTM_x>1</site_UTM_x>",
                  "s.xml:1:1: expected at least one timeSeries element"},
        BadSensor{"Broken", "<a>\n</b>\n", "s.xml:2:3: broken XML: Start-end tags mismatch"},
        BadSensor{"Binary", std::string("<a>\n\0</a>", 9), "s.xml:2:1: expected text, found binary data"},
        BadSensor{"Missing", "<a/>\n" + record("0", "1", "2", "<siteZ0>0.1</siteZ0>"),
                  "s.xml:2:2: height: expected this element in timeSeries"},
        BadSensor{"Twice",
                  record("0", "1", "2", "<siteZ0>0.1</siteZ0><height>1</height>\n<height>2</height>\n"),
                  "s.xml:4:2: height: expected this element once in timeSeries"},
        BadSensor{"TextInNumber", record("0", "1 m/s", "2"),
                  "s.xml:5:2: speed: expected a wind speed of 0 to 200 m/s, found '1 m/s'"},
        BadSensor{"NumberInTwoPieces", record("0", "1<!-- -->.5", "2"),
                  "s.xml:5:2: speed: expected a wind speed of 0 to 200 m/s, found '1'"},
        BadSensor{"EmptyElement", record("0", "1", ""),
                  "s.xml:6:2: direction: expected degrees of -360 to 360, found nothing"},
        BadSensor{"NegativeSpeed", record("0", "-1", "2"),
                  "s.xml:5:2: speed: expected a wind speed of 0 to 200 m/s, found '-1'"},
        BadSensor{"NanSpeed", record("0", "nan", "2"),
                  "s.xml:5:2: speed: expected a wind speed of 0 to 200 m/s, found 'nan'"},
        BadSensor{"MissingDirectionCode", record("0", "1", "999"),
                  "s.xml:6:2: direction: expected degrees of -360 to 360, found '999'"},
        BadSensor{"OutOfOrder", record("10", "1", "2") + record("9", "1", "2"),
                  "s.xml:9:2: timeEpoch: expected a later time than in the record before, found '9'"},
        BadSensor{"TimeTwice", record("10", "1", "2") + record("10", "1", "2"),
                  "s.xml:9:2: timeEpoch: expected a later time than in the record before, found '10'"},
        BadSensor{"RoughnessAboveHeight", record("0", "1", "2", "<siteZ0>5</siteZ0><height>2</height>"),
                  "s.xml:1:2: siteZ0: expected a roughness length below the height"},
        BadSensor{"ZeroRoughness", record("0", "1", "2", "<siteZ0>0</siteZ0><height>2</height>"),
                  "s.xml:3:2: siteZ0: expected metres above 0, found '0'"},
        BadSensor{"HeightChanges",
                  record("0", "1", "2") + record("1", "1", "2", "<siteZ0>0.1</siteZ0><height>2</height>"),
                  "s.xml:8:2: height: expected the height and siteZ0 of the first record, 10 and 0.1"},
        BadSensor{"PowerLaw",
                  record("0", "1", "2",
                         "<siteZ0>0.1</siteZ0><height>2</height><boundaryLayerFlag>2</boundaryLayerFlag>"),
                  "s.xml:3:40: boundaryLayerFlag: expected 1 (logarithmic profile), found '2'"},
        BadSensor{"NotNeutral",
                  record("0", "1", "2", "<siteZ0>0.1</siteZ0><height>2</height><reciprocal>1</reciprocal>"),
                  "s.xml:3:40: reciprocal: expected 0 (neutral stability), found '1'"}),
    [](const auto& info) { return info.param.name; });

TEST(QesSensor, RealRecordSpotValues) {
    REQUIRE_REAL_DATA(path, "utah_campus/sensor2015.xml");
    const auto read384 = read(fileText(path));
    ASSERT_TRUE(read384) << firstProblem(read384);
    const WindSeries& series = read384.value();
    ASSERT_EQ(series.times.size(), 384u);
    EXPECT_EQ(series.times[1], 1800.0);
    EXPECT_EQ(series.times.back(), 689400.0);
    ASSERT_TRUE(series.profile);
    EXPECT_EQ(series.profile->height, 42.0);
    EXPECT_EQ(series.profile->roughness, 0.1);
    // 3.1 m/s from 78.4 degrees (a little north of east): blows west and a little south.
    EXPECT_NEAR(series.velocities[0].x, -3.03667f, 1e-4f);
    EXPECT_NEAR(series.velocities[0].y, -0.62335f, 1e-4f);
    EXPECT_EQ(series.velocities[0].z, 0.0f);
}

TEST(QesSensor, RealRecordMatchesAPlainTextSearch) {
    REQUIRE_REAL_DATA(path, "utah_campus/sensor2015.xml");
    const std::string text = fileText(path);
    const auto series = read(text);
    ASSERT_TRUE(series) << firstProblem(series);
    const auto times = numbersIn(text, "timeEpoch"), speeds = numbersIn(text, "speed"),
               directions = numbersIn(text, "direction");
    ASSERT_EQ(series.value().times.size(), times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
        EXPECT_EQ(series.value().times[i], times[i] - times[0]);
        const glm::vec3& v = series.value().velocities[i];
        EXPECT_NEAR(std::hypot(v.x, v.y), speeds[i], 1e-5) << i;
        const double from = std::atan2(-v.x, -v.y) * 180.0 / 3.14159265358979;
        EXPECT_NEAR(std::remainder(from - directions[i], 360.0), 0.0, 1e-4) << i;
    }
}

TEST(QesSensor, TruncatedRealFileIsARecordOrAProblem) {
    REQUIRE_REAL_DATA(path, "utah_campus/sensor2015.xml");
    const std::string text = fileText(path);
    int whole = 0, broken = 0;
    for (std::size_t length = 0; length < text.size(); length += 500) {
        const auto series = read(text.substr(0, length));
        if (series) {
            ++whole;
            EXPECT_EQ(series.value().times.size(), series.value().velocities.size());
        } else {
            ++broken;
            EXPECT_FALSE(firstProblem(series).empty());
        }
    }
    EXPECT_GT(broken, whole);
}

TEST(QesSensor, TruncatedSmallFileIsARecordOrAProblem) {
    const std::string text =
        "<?xml version=\"1.0\"?>\n<!-- c -->" + record("1", "2", "3") + record("2", "2", "3");
    for (std::size_t length = 0; length < text.size(); ++length) {
        const auto series = read(text.substr(0, length));
        if (series)
            EXPECT_LE(series.value().times.size(), 2u);
        else
            EXPECT_FALSE(firstProblem(series).empty());
    }
}
