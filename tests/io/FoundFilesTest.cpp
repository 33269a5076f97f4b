// SPDX-License-Identifier: MIT

// Files of cities, weather services and other programs: synthetic ones and those of shared/data/cases.
#include <tests/TestData.h>
#include <tests/base/FirstProblem.h>
#include <tests/base/IsProblem.h>
#include <tests/io/InventoryReading.h>

#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/windfiles/WindFile.h>

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace osgTreeWind {

namespace {

ForestFile forestIn(const std::string& folder, const std::string& text) {
    std::istringstream input("version = 1\n" + text);
    Result<ForestFile> forest = readForest(input, {"f.treewind", folder});
    EXPECT_TRUE(forest) << firstProblem(forest);
    return forest ? std::move(forest.value()) : ForestFile();
}

ForestFile caseOf(const std::string& file) {
    Result<ForestFile> forest = readForestFile(file);
    EXPECT_TRUE(forest) << firstProblem(forest);
    return forest ? std::move(forest.value()) : ForestFile();
}

std::string speciesOf(const ForestFile& forest, std::size_t tree) {
    return forest.species[forest.trees.at(tree).species].name;
}

} // namespace

/// A spreadsheet with semicolons, decimal commas, Latin-1, German names, gaps and zeros.
TEST(FoundFiles, ReadsATypicalSpreadsheet) {
    const char* const names[] = {"Spitz-Ahorn", "Winterlinde", "Platane",  "Stieleiche",   "Ro\xdfkastanie",
                                 "Hainbuche",   "Sandbirke",   "Rotbuche", "Schwarz-Erle", "Gemeine Kiefer",
                                 "Eberesche",   "Robinie",     "Esche",    "Kugelahorn",   "Quitte"};
    std::ostringstream table;
    table << "Baum-Nr.;Rechtswert;Hochwert;Baumart;H\xf6he (m);Stammumfang (cm);Krone (m)\r\n";
    for (int i = 0; i < 60; ++i)
        table << 'B' << i << ";3567" << 10 + i << ",5;56450" << 10 + i << ",25;" << names[i % 15] << ';'
              << (i % 7 == 0   ? "0"
                  : i % 5 == 0 ? ""
                               : "12,5")
              << ';' << (i % 4 == 0 ? "0" : "95") << ";6,2\r\n";
    const TemporaryFolder folder;
    folder.write("baeume.csv", table.str());
    const ForestFile forest =
        forestIn(folder.path(),
                 "[inventory]\nfile = \"baeume.csv\"\ncolumns = { id = \"Baum-Nr.\", x = \"Rechtswert\", y = "
                 "\"Hochwert\", species = \"Baumart\", height = \"H\xc3\xb6he (m)\", circumference = "
                 "\"Stammumfang (cm)\", crown_width = \"Krone (m)\" }\nunits = { circumference = \"cm\" }\n");
    ASSERT_EQ(forest.trees.size(), 60u);
    EXPECT_DOUBLE_EQ(forest.trees[1].position.x, 356711.5);
    EXPECT_FLOAT_EQ(forest.trees[1].size.height, 12.5f);
    EXPECT_FLOAT_EQ(forest.trees[1].size.crownWidth, 6.2f);
    EXPECT_TRUE(forest.trees[0].estimated.height);
    const char* const species[] = {
        "Norway maple", "linden",       "London plane", "oak",       "horse chestnut",
        "broadleaf",    "silver birch", "beech",        "broadleaf", "Scots pine",
        "broadleaf",    "honey locust", "ash",          "sycamore",  "broadleaf"};
    for (std::size_t i = 0; i < 15; ++i)
        EXPECT_EQ(speciesOf(forest, i), species[i]) << names[i];
    const std::string notes = notesOf(forest);
    for (const char* const note :
         {"is no UTF-8 and is read as Windows-1252",
          "its cells are separated by \";\", and its numbers may have decimal commas",
          "4 trees of unknown species are read as related species: Kugelahorn as sycamore "
          "(4)",
          "4 trees of unknown species are read as \"broadleaf\": Quitte (4)",
          "0 and markers such as -99 count as not measured: circumference of 15, height of 9 rows",
          "no crs is known, and places are taken as metres; inventory.crs sets a system",
          "estimated by the laws of the species"})
        EXPECT_TRUE(hasPart(notes, note)) << note << "\nin\n" << notes;
    EXPECT_EQ(forest.notes.size(), 8u) << notes;
}

/// Thousands separators count where all cells of the column are such numbers.
TEST(FoundFiles, ReadsThousandsSeparators) {
    const TemporaryFolder folder;
    const std::string lines = "[inventory]\nfile = \"a.csv\"\ncolumns = { x = \"X\", y = \"Y - 1\" }\n";
    folder.write("a.csv", "sep=;\nX;Y\n2'600'100,5;1\u202f200\u202f051\n2'600'110.5;-\n2600120;1200052\n");
    const ForestFile forest = forestIn(folder.path(), "origin = [2600000, 1200000, 0]\n" + lines);
    ASSERT_EQ(forest.trees.size(), 2u);
    EXPECT_EQ(forest.trees[0].position, glm::dvec3(2600100.5, 1200050.0, 0.0));
    EXPECT_EQ(forest.trees[1].position, glm::dvec3(2600120.0, 1200051.0, 0.0));
    folder.write("a.csv", "sep=;\nX;Y\n12 345;1\n12 34;2\n");
    std::istringstream input("version = 1\n" + lines);
    EXPECT_TRUE(hasPart(firstProblem(readForest(input, {"f.treewind", folder.path()})),
                        "a.csv:3: X: expected a number, found '12 345'"));
}

TEST(FoundFiles, ReadsTablesAsTheirKeysSay) {
    const TemporaryFolder folder;
    folder.write("a.csv", "oak,7,8\n! moved\noak,9,8\n");
    EXPECT_EQ(forestIn(folder.path(), "[inventory]\nfile = \"a.csv\"\nheader_line = 0\ncomment = \"!\"\n"
                                      "columns = { x = \"2\", y = \"3\", species = \"1\" }\n")
                  .trees.at(1)
                  .position,
              glm::dvec3(9.0, 8.0, 0.0));
    folder.write("b.txt", "x y\n1 2\nx  y  h\n3  4  5\n");
    EXPECT_EQ(forestIn(folder.path(),
                       "[inventory]\nfile = \"b.txt\"\nheader_line = 3\ndelimiter = \"blanks\"\n"
                       "columns = { x = \"x\", y = \"y\" }\n")
                  .trees.at(0)
                  .position,
              glm::dvec3(3.0, 4.0, 0.0));
    folder.write("c.csv", "0,5,6\n! battery\n10,6,7\n");
    const ForestFile forest = forestIn(
        folder.path(), "[wind]\nkind = \"series\"\nfile = \"c.csv\"\nheader_line = 0\ncomment = \"!\"\n"
                       "columns = { time = \"1\", u = \"2\", v = \"3\" }\n[[tree]]\nposition = [0, 0]\n");
    EXPECT_FLOAT_EQ(forest.wind.field->velocity({0, 0, 5}, 10.0).y, 7.0f);
}

TEST(FoundFiles, FindsRelatedSpecies) {
    const SpeciesCatalogue& ours = SpeciesCatalogue::builtIn();
    for (const auto& [name, species] : {std::pair("Eastern White Pine", "Scots pine"),
                                        {"WHITE OAK", "oak"},
                                        {"London Planetree", "London plane"},
                                        {"Colorado Blue Spruce", "white spruce"},
                                        {"Halka Honey Locust", "honey locust"},
                                        {"Green Ash", "ash"},
                                        {"Canary Island Date Palm", "palm"},
                                        {"Kugel-Ahorn", "sycamore"},
                                        {"S\xc3\xa4uleneiche", "oak"}}) {
        const Species* kin = ours.findRelated(name);
        EXPECT_EQ(kin ? kin->name : "", species) << name;
    }
    for (const char* const name : {"STUMP", "Unknown", "TBD", "", "Quitte", "oak stump"})
        EXPECT_FALSE(ours.findRelated(name)) << name;
    for (const auto& [name, species] : {std::pair("Maple, Norway", "Norway maple"),
                                        {"Maple - Norway", "Norway maple"},
                                        {"Acer platanoides 'Globosum'", "Norway maple"},
                                        {"TILIA\xc2\xa0 CORDATA", "linden"},
                                        {"ch\xc3\xaa"
                                         "ne p\xc3\xa9"
                                         "doncul\xc3\xa9",
                                         "oak"},
                                        {"Chene pedoncule", "oak"},
                                        {"Haya", "beech"},
                                        {"pl\xc3\xa1tano de sombra", "London plane"},
                                        {"Zomereik", "oak"},
                                        {"pino silvestre", "Scots pine"},
                                        {"Hetre", "beech"},
                                        {"Gewoehnliche Rosskastanie", "horse chestnut"}}) {
        const Species* found = ours.find(name);
        EXPECT_EQ(found ? found->name : "", species) << name;
    }
}

TEST(FoundFiles, ReadsAPlaceFromOneCell) {
    const TemporaryFolder folder;
    const std::string lines = "[inventory]\nfile = \"a.csv\"\n";
    folder.write("a.csv", "id;geo_point_2d\n1;48.8760, 2.3007\n2;48.8761, 2.3009\n");
    for (const char* const columns :
         {"columns = { id = \"id\" }\n", "columns = { point = \"geo_point_2d\" }\n",
          "columns = { x = \"geo_point_2d\", y = \"geo_point_2d\" }\n"}) {
        const ForestFile forest = forestIn(folder.path(), lines + columns);
        EXPECT_EQ(forest.crs, "EPSG:32631");
        ASSERT_EQ(forest.trees.size(), 2u);
        const glm::dvec3 apart = forest.trees[1].position - forest.trees[0].position;
        EXPECT_NEAR(apart.x, 14.7, 0.2) << "2e-4 degrees of longitude";
        EXPECT_NEAR(apart.y, 11.1, 0.2);
    }
    folder.write("a.csv", "id,wkt\n1,POINT (2.3007 48.8760)\n2,POINT Z (2.3009 48.8761 30)\n3,nowhere\n");
    const ForestFile forest = forestIn(folder.path(), lines + "columns = { id = \"id\" }\n");
    ASSERT_EQ(forest.trees.size(), 2u);
    EXPECT_NEAR(forest.trees[1].position.x - forest.trees[0].position.x, 14.7, 0.2);
    EXPECT_TRUE(hasPart(notesOf(forest), "1 of 3 rows have no place"));
    folder.write("a.csv", "point\n\"356000, 5645000\"\n");
    EXPECT_EQ(forestIn(folder.path(), lines + "crs = \"EPSG:25832\"\ncolumns = { point = \"point\" }\n")
                  .trees.at(0)
                  .position.x,
              356000.0);
}

TEST(FoundFiles, ReprojectsWebMaps) {
    const TemporaryFolder folder;
    // 2.35 E 48.85 N, and places 100 m east and north of it, by PROJ's geod and cs2cs.
    folder.write("a.csv",
                 "x,y\n261600.8034,6249447.7528\n261752.4828,6249447.7514\n261600.8034,6249599.8763\n");
    const std::string lines =
        "[inventory]\nfile = \"a.csv\"\ncrs = \"EPSG:3857\"\ncolumns = { x = \"x\", y = \"y\" }\n";
    const ForestFile forest = forestIn(folder.path(), lines);
    EXPECT_EQ(forest.crs, "EPSG:32631");
    ASSERT_EQ(forest.trees.size(), 3u);
    for (std::size_t i = 1; i < 3; ++i)
        EXPECT_NEAR(glm::distance(forest.trees[i].position, forest.trees[0].position), 100.0, 0.1);
    EXPECT_TRUE(
        hasPart(notesOf(forest), "a metre of WGS 84 / Pseudo-Mercator is 0.657 m on the ground here"));

    const ForestFile stated = forestIn(
        folder.path(),
        "crs = \"EPSG:3857\"\norigin = [261600.8034, 6249447.7528, 0]\n[[tree]]\nposition = [261600.8034, "
        "6249447.7528]\n[[tree]]\nposition = [261752.4828, 6249447.7514]\n[wind]\nkind = "
        "\"calm\"\n[[wind.source]]"
        "\nkind = \"jet\"\nposition = [261752.4828, 6249447.7514, 2]\nvelocity = [9, 0, 0]\nradius = 1.0\n");
    EXPECT_EQ(stated.crs, "EPSG:32631");
    ASSERT_EQ(stated.trees.size(), 2u);
    EXPECT_NEAR(glm::distance(stated.trees[1].position, stated.trees[0].position), 100.0, 0.1);
    EXPECT_NEAR(glm::distance(stated.trees[0].position, stated.origin), 0.0, 1e-3);
    ASSERT_EQ(stated.wind.sources.size(), 1u);
    EXPECT_NEAR(glm::length(glm::dvec2(stated.wind.sources[0].position)), 100.0, 0.1);

    const ForestFile kept = forestIn(folder.path(), "stretched = true\ncrs = \"EPSG:3857\"\n" + lines);
    EXPECT_EQ(kept.crs, "EPSG:3857");
    std::ostringstream written;
    EXPECT_TRUE(writeForest(kept, written).empty());
    std::istringstream again(written.str());
    EXPECT_EQ(readForest(again).value().trees.at(1).position, kept.trees[1].position);
}

TEST(FoundFiles, SpacingIsInMetresOnTheGround) {
    const TemporaryFolder folder;
    const std::string scatter = "crs = \"EPSG:3857\"\n[scatter]\narea = [261600, 6249400, 261632, "
                                "6249432]\ncount = 36\nspacing = 3\n";
    const auto nearest = [](const ForestFile& forest) {
        double least = 1e9;
        for (const TreePlacement& a : forest.trees)
            for (const TreePlacement& b : forest.trees)
                least = &a == &b ? least : std::min(least, glm::distance(a.position, b.position));
        return least;
    };
    // 36 trees 3 m apart in 32 x 32 m are so dense that some pairs are barely farther apart.
    EXPECT_NEAR(nearest(forestIn(folder.path(), scatter)), 3.0, 0.25);
    EXPECT_NEAR(nearest(forestIn(folder.path(), "stretched = true\n" + scatter)), 3.0, 0.25);
}

TEST(FoundFiles, DoesNotTreatTimesOfNinesAsMissing) {
    const TemporaryFolder folder;
    folder.write("a.csv", "time,u,v\n998,1,0\n999,2,0\n1000,M,0\n9999,3,0\n");
    const WindFile wind = readWindFile(folder.path() + "/a.csv").value();
    EXPECT_EQ(wind.summary.times, (std::vector<double>{0.0, 1.0, 9001.0}));
}

TEST(FoundFiles, ReadsInventories) {
    REQUIRE_REAL_DATA(zero, "cases/01-zero-means-unknown/trees.treewind");
    EXPECT_EQ(caseOf(zero).trees.size(), 6u);
    REQUIRE_REAL_DATA(census, "cases/01-zero-means-unknown/census.csv");
    EXPECT_EQ(
        forestIn(
            "", "[inventory]\nfile = \"" + census +
                    "\"\ncolumns = { x = \"longitude\", y = \"latitude\", species = \"spc_latin\", "
                    "trunk_diameter = \"tree_dbh\" }\nunits = { trunk_diameter = \"in\" }\nfilter = \"status "
                    "<> 'Stump'\"\n")
            .trees.size(),
        2u);
    REQUIRE_REAL_DATA(mercator, "cases/02-web-mercator/trees.treewind");
    const ForestFile apart = caseOf(mercator);
    EXPECT_NEAR(glm::distance(apart.trees.at(1).position, apart.trees.at(0).position), 100.0, 0.1);
    REQUIRE_REAL_DATA(plot, "cases/03-decimal-comma/plot.treewind");
    const ForestFile commas = caseOf(plot);
    EXPECT_EQ(commas.trees.at(1).position, glm::dvec3(2.15, 3.0, 0.0));
    EXPECT_NEAR(commas.trees.at(1).size.trunkDiameter, 0.1225f, 1e-6f);
    REQUIRE_REAL_DATA(header, "cases/04-latin1-table/header.treewind");
    EXPECT_EQ(caseOf(header).trees.at(0).name, "S\xc3\xbc"
                                               "d 1");
    for (const char* const file : {"point", "wkt"}) {
        REQUIRE_REAL_DATA(point, std::string("cases/19-point-in-one-column/") + file + ".treewind");
        EXPECT_EQ(speciesOf(caseOf(point), 0), "horse chestnut");
    }
    REQUIRE_REAL_DATA(bands, "cases/18-elevation-in-many-bands/t.treewind");
    EXPECT_NEAR(caseOf(bands).ground->height({727315.0, 5211235.0}).value_or(0.0), 1035.0, 2.0)
        << "of a cell, and bilinear";
}

TEST(FoundFiles, ReadsScans) {
    for (const char* const file : {"cylinder_orphan_txt", "orphan_csv", "orphan_mat", "orphan_swc"}) {
        REQUIRE_REAL_DATA(path, std::string("cases/09-qsm-orphans/") + file + ".treewind");
        const ForestFile forest = caseOf(path);
        const ScanReport& report = forest.species.at(0).tree.scans->at(0).report;
        const bool isSwc = std::string(file) == "orphan_swc"; // its radii are those of the upper ends
        EXPECT_NEAR(report.cylinderVolume, isSwc ? 0.43478 : 0.4388, 2.5e-4) << file;
        EXPECT_NEAR(report.height, 8.0, 1e-6) << file;
        EXPECT_TRUE(hasPart(notesOf(forest), "1 branches without a parent"));
    }
    REQUIRE_REAL_DATA(path, "cases/10-qsm-pytlidar/tree.treewind");
    const ForestFile forest = caseOf(path);
    const ScanReport& report = forest.species.at(0).tree.scans->at(0).report;
    EXPECT_NEAR(report.cylinderVolume, 0.447106097, 1e-6);
    EXPECT_EQ(report.cylinders, 8u);
}

TEST(FoundFiles, ReadsRecords) {
    const auto velocity = [](const ForestFile& forest, double time) {
        return asField(forest.wind)->velocity({0.0f, 0.0f, 10.0f}, time);
    };
    REQUIRE_REAL_DATA(commas, "cases/03-decimal-comma/station.treewind");
    EXPECT_NEAR(velocity(caseOf(commas), 0.0).x, 5.25f, 1e-4f);
    for (const char* const file : {"iem", "service", "empty", "sentinel"}) {
        REQUIRE_REAL_DATA(path, std::string("cases/15-station-gaps/") + file + ".treewind");
        const ForestFile forest = caseOf(path);
        EXPECT_TRUE(hasPart(notesOf(forest), "1 of "));
        EXPECT_LT(glm::length(velocity(forest, 60.0)), 10.0f) << file;
    }
    REQUIRE_REAL_DATA(epw, "cases/16-epw/year.treewind");
    const glm::vec3 second = velocity(caseOf(epw), 3600.0);
    EXPECT_NEAR(glm::length(second), 2.2f, 1e-4f);
    EXPECT_NEAR(second.y, 2.2f * std::cos(glm::radians(20.0f)), 1e-4f) << "from 200 degrees";
    for (const char* const file : {"sensor_epoch", "sensor_stamp"}) {
        REQUIRE_REAL_DATA(path, std::string("cases/12-qes-timestamp/") + file + ".xml");
        const WindFile wind = readWindFile(path).value();
        EXPECT_EQ(wind.summary.start, "2020-01-01T01:00:00Z") << file;
        EXPECT_EQ(wind.summary.times, (std::vector<double>{0.0, 1800.0})) << file;
    }
}

TEST(FoundFiles, ReadsGriddedWinds) {
    const std::string folder = "cases/11-wind-not-over-forest/";
    for (const char* const file : {"era5_sydney", "era5_edge", "map_385900", "map_386800", "map_395000",
                                   "palm_far", "sydney_in_french_wind"}) {
        REQUIRE_REAL_DATA(path, folder + file + ".treewind");
        const auto forest = readForestFile(path);
        EXPECT_TRUE(hasPart(firstProblem(forest), "no tree is inside the grid of")) << file;
        const auto held = readForestFile(path, 100, {"wind.beyond=hold"});
        ASSERT_TRUE(held) << firstProblem(held);
        EXPECT_TRUE(hasPart(notesOf(held.value()), "1 of 1 trees stand outside the grid of")) << file;
    }
    REQUIRE_REAL_DATA(both, folder + "one_in_one_out.treewind");
    const std::string notes = notesOf(caseOf(both));
    EXPECT_TRUE(hasPart(notes, "map.nc, x 385000 to 385700, y "));
    REQUIRE_REAL_DATA(palm, folder + "palm_far.treewind");
    const auto far = readForestFile(palm, 100, {"wind.beyond=hold"});
    ASSERT_TRUE(far) << firstProblem(far);
    EXPECT_NEAR(asField(far.value().wind)->velocity({0.0f, 0.0f, 10.0f}, 0.0).x, 2.52f, 0.01f)
        << "of the last cell";
    for (const char* const file : {"grib", "nc"}) {
        REQUIRE_REAL_DATA(path, std::string("cases/17-components-in-two-files/") + file + ".treewind");
        EXPECT_TRUE(hasPart(notesOf(caseOf(path)), "read from pairs of files")) << file;
    }
    REQUIRE_REAL_DATA(u, "cases/17-components-in-two-files/u_10m.grib2");
    REQUIRE_REAL_DATA(v, "cases/17-components-in-two-files/v_10m.grib2");
    WindFileOptions options;
    options.origin = {9.3, 50.2, 0.0};
    options.asStored = true;
    const auto wind = readWindFiles({u, v}, {}, options);
    ASSERT_TRUE(wind) << firstProblem(wind);
    const glm::vec3 velocity = asField(wind.value().wind)->velocity({0.0f, 0.0f, 10.0f}, 0.0);
    EXPECT_NEAR(velocity.x, 2.93f, 0.01f);
    EXPECT_NEAR(velocity.y, -1.51f, 0.01f);
}

} // namespace osgTreeWind
