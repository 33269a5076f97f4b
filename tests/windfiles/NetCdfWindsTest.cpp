// SPDX-License-Identifier: MIT
// Which arrays of a NetCDF file are the wind.
#include <tests/windfiles/NetCdfWriting.h>
#include <tests/windfiles/Notes.h>

namespace osgTreeWind {

namespace {

using Names = std::vector<std::string>;

class NetCdfWindsTest : public testing::Test {
protected:
    void SetUp() override {
        _writer.emplace(path()).axis("y", {0, 10}, "m").axis("x", {0, 10, 20}, "m");
        _writer->axis("height", {5, 15}, "m", {{"positive", "up"}});
    }

    std::string path() const { return _folder.path() + "/wind.nc"; }

    /// Adds an array with one value at all points.
    void add(const std::string& name, double value, const NetCdfAttributes& attributes = metresPerSecond,
             const Names& dimensions = {"y", "x"}) {
        _writer->array(name, dimensions, attributes, Numbers(dimensions.size() == 3 ? 12 : 6, value));
    }
    void addOfStandard(const std::string& name, double value, const std::string& standard) {
        add(name, value, {{"units", "m s-1"}, {"standard_name", standard}});
    }

    Result<WindContent> read(const Names& variable = {}) {
        _writer.reset();
        WindRequest request;
        request.variable = variable;
        return readNetCdf(path(), request);
    }

    void expectVelocity(const Names& variable, const glm::vec3& expected) {
        const Result<WindContent> content = read(variable);
        ASSERT_TRUE(content) << firstProblem(content);
        expectNear(velocityAt(std::get<GridWind::Grid>(content.value().data), 0, 0, 0, 0), expected, 1e-5f);
    }
    void expectProblem(const Names& variable, const std::string& problem) {
        EXPECT_EQ(firstProblem(read(variable)), path() + ": " + problem);
    }

    TemporaryFolder _folder;
    std::optional<NetCdfWriter> _writer;
};

} // namespace

TEST_F(NetCdfWindsTest, RefusesSeveralPairsOnTheSamePoints) {
    addOfStandard("u", 1, "eastward_wind");
    addOfStandard("v", 2, "northward_wind");
    addOfStandard("u_mean", 3, "eastward_wind");
    addOfStandard("v_mean", 4, "northward_wind");
    expectProblem({}, "expected one wind, found u and u_mean on the same points; wind.variable names one");
    expectVelocity({"u"}, {1, 2, 0});
    expectVelocity({"u_mean"}, {3, 4, 0});
}

TEST_F(NetCdfWindsTest, RefusesSeveralSpeedsOnTheSamePoints) {
    addOfStandard("fast", 4, "wind_speed");
    addOfStandard("slow", 2, "wind_speed");
    add("wd", 270, {{"units", "degree"}, {"standard_name", "wind_from_direction"}});
    expectProblem({}, "expected one wind, found fast and slow on the same points; wind.variable names one");
    expectVelocity({"slow"}, {2, 0, 0});
    expectVelocity({"fast", "wd"}, {4, 0, 0});
}

TEST_F(NetCdfWindsTest, NotesPairsOnOtherPoints) {
    add("u", 1, metresPerSecond, {"height", "y", "x"});
    add("v", 2, metresPerSecond, {"height", "y", "x"});
    add("u10", 3);
    add("v10", 4);
    const Result<WindContent> content = read();
    ASSERT_TRUE(content) << firstProblem(content);
    EXPECT_TRUE(
        hasNote(content.value().summary, "the wind is read from u; wind.variable chooses another of u10"));
    expectVelocity({"u10"}, {3, 4, 0});
    const Result<WindContent> named = read({"u10"});
    ASSERT_TRUE(named) << firstProblem(named);
    EXPECT_EQ(std::get<GridWind::Grid>(named.value().data).heights, std::vector<float>{10});
    EXPECT_TRUE(named.value().summary.notes.empty());
}

TEST_F(NetCdfWindsTest, ReadsUnusualNamesThatTheUserGives) {
    add("gust_u", 1);
    add("gust_v", 2);
    add("towardEast", 3);
    add("towardNorth", 4);
    add("rise", 5);
    add("strength", 6);
    add("origin", 180, {{"units", "degrees"}});
    expectProblem(
        {}, "expected arrays of wind: x_wind and y_wind, eastward_wind and northward_wind, u and v, u10 "
            "and v10, or wind_speed and wind_from_direction; wind.variable names others, of gust_u, "
            "gust_v, towardEast, towardNorth, rise, strength, origin");
    expectVelocity({"gust_u"}, {1, 2, 0});
    expectVelocity({"towardEast", "towardNorth"}, {3, 4, 0});
    expectVelocity({"towardEast", "towardNorth", "rise"}, {3, 4, 5});
    expectVelocity({"strength", "origin"}, {0, 6, 0});
    expectProblem({"rise"},
                  "expected the second component or the direction beside rise; wind.variable names both, "
                  "as [\"EAST\", \"NORTH\"], of gust_u, gust_v, towardEast, towardNorth, rise, "
                  "strength, origin");
    expectProblem({"u"},
                  "expected 1 to 3 arrays of wind that wind.variable names: gust_u, gust_v, towardEast, "
                  "towardNorth, rise, strength, origin, found 'u'");
}

} // namespace osgTreeWind
