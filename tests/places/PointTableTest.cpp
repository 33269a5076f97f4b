// SPDX-License-Identifier: MIT
#include <tests/places/GeoJson.h>

#include <osgTreeWind/places/PointTable.h>
#include <osgTreeWind/places/VectorFile.h>

namespace osgTreeWind {

TEST(PointTable, GeoPackageReadsBack) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/trees.gpkg";
    PointTable table;
    table.name = "risk";
    table.crs = "EPSG:32612";
    table.texts = {"id"};
    table.numbers = {"height_m", "break_ms"};
    table.rows = {{{430000.25, 4500000.5, 7.0}, {"a \"b\", c"}, {12.5, std::nullopt}}};
    const Diagnostics problems = writeGeoPackage(table, path);
    ASSERT_TRUE(problems.empty()) << problems.front().text();
    auto file = VectorFile::open(path);
    ASSERT_TRUE(file) << file.problems().front().text();
    VectorFile& read = file.value();
    ASSERT_TRUE(read.chooseLayer("risk").empty());
    EXPECT_EQ(read.columns(), (std::vector<std::string>{"id", "height_m", "break_ms"}));
    ASSERT_TRUE(read.crs());
    EXPECT_EQ(read.crs()->text(), "EPSG:32612");
    ASSERT_TRUE(read.next().value());
    EXPECT_EQ(read.text(0), "a \"b\", c");
    EXPECT_EQ(read.number(1), 12.5);
    EXPECT_FALSE(read.has(2));
    EXPECT_EQ(read.place().value().position, glm::dvec3(430000.25, 4500000.5, 7.0));
    EXPECT_FALSE(read.next().value());
}

TEST(PointTable, ReportsWhyItCannotBeWritten) {
    PointTable table;
    table.name = "risk";
    const Diagnostics nowhere = writeGeoPackage(table, "/nowhere/trees.gpkg");
    ASSERT_FALSE(nowhere.empty());
    EXPECT_NE(nowhere.front().text().find("/nowhere/trees.gpkg: cannot be written"), std::string::npos)
        << nowhere.front().text();
    table.crs = "no map";
    EXPECT_FALSE(writeGeoPackage(table, TemporaryFolder().path() + "/a.gpkg").empty());
}

} // namespace osgTreeWind
