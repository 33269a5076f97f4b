// SPDX-License-Identifier: MIT
#include <tests/tool/NetCdf.h>
#include <tests/tool/Pictures.h>
#include <tests/tool/Tool.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

namespace {

/// Rows of a table of numbers by column; the column id has texts.
struct Rows {
    std::string header;
    std::map<std::string, std::vector<double>> numbers; ///< NaN for empty cells.
    std::vector<std::string> ids;

    explicit Rows(const std::string& csv) {
        std::istringstream lines(csv);
        std::getline(lines, header);
        for (std::string line; std::getline(lines, line);) {
            std::istringstream names(header), cells(line);
            std::string name, cell;
            while (std::getline(names, name, ',') && name != "id") {
                std::getline(cells, cell, ',');
                numbers[name].push_back(cell.empty() ? std::nan("") : std::stod(cell));
            }
            EXPECT_EQ(name, "id") << "the last column";
            ids.emplace_back();
            std::getline(cells, ids.back());
        }
    }
    std::size_t size() const { return ids.size(); }
};

class SimulateTables : public testing::Test {
protected:
    const TemporaryFolder folder;

    void SetUp() override {
        folder.write("wind.dat", "\"TOA5\",s,CR1000,1,os,program,1,ts\nTIMESTAMP,RECORD,Ux,Uy,Uz\n"
                                 "TS,RN,m/s,m/s,m/s\n,,Smp,Smp,Smp\n\"2024-03-05 12:00:00.5\",0,12,0,0\n"
                                 "\"2024-03-05 12:10:00.5\",1,12,0,0\n");
        folder.write(
            "wood.treewind",
            "version = 1\ncrs = \"EPSG:25832\"\norigin = [500000, 5500000, 100]\n"
            "[wind]\nfile = \"wind.dat\"\n"
            "[[tree]]\nspecies = \"Norway spruce\"\nid = \"old, tall\"\n"
            "position = [500010, 5500005, 100]\nheight = 20\n"
            "[[tree]]\nspecies = \"oak\"\nid = \"0\"\nposition = [500040, 5500005, 100]\nheight = 12\n"
            "[[tree]]\nspecies = \"oak\"\nposition = [500070, 5500005, 100]\nheight = 12\n");
    }
    Outcome simulate(std::vector<std::string> words) const {
        words.insert(words.begin(), {"simulate", "--duration", "6", "--fps", "5"});
        words.emplace_back("wood.treewind");
        return runTool(words, folder.path());
    }
    Rows rows(const std::vector<std::string>& words) const {
        const Outcome outcome = simulate(words);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return Rows(outcome.out);
    }
    std::string at(const std::string& name) const { return folder.path() + '/' + name; }
};

} // namespace

TEST_F(SimulateTables, TopsAreThoseOfTheHighestTips) {
    std::string calm = contentOf(at("wood.treewind")); // so that tables that start at rest agree
    calm.replace(calm.find("file = \"wind.dat\""), 17, "kind = \"calm\"");
    folder.write("wood.treewind", calm);
    const Rows tops = rows({"--tops"}), tips = rows({"--tips"});
    EXPECT_EQ(tops.header, "time,tree,top_x,top_y,top_z,rest_x,rest_y,rest_z,id");
    ASSERT_EQ(tops.size(), 3u * 31u);
    EXPECT_EQ(tops.ids[0], "\"old, tall\"");
    EXPECT_EQ(tops.ids[2], "");
    EXPECT_NEAR(tops.numbers.at("rest_z")[0], 20.0, 0.01) << "the height, from the origin of the scene";
    EXPECT_NEAR(tops.numbers.at("rest_x")[0], 10.0, 1.0);
    for (std::size_t i = 0; i < tops.size(); ++i) {
        bool isTip = false;
        for (std::size_t j = 0; j < tips.size() && !isTip; ++j) {
            isTip = tips.numbers.at("time")[j] == tops.numbers.at("time")[i];
            for (const std::string axis : {"x", "y", "z"})
                isTip = isTip && tips.numbers.at("tip_" + axis)[j] == tops.numbers.at("top_" + axis)[i];
        }
        EXPECT_TRUE(isTip) << i;
    }
}

TEST_F(SimulateTables, TreesByIdThenByNumber) {
    const Rows chosen = rows({"--tops", "--trees", "2,0,1", "--every", "10"});
    ASSERT_EQ(chosen.size(), 2u * 4u) << "tree 1 has the id 0 and comes once";
    EXPECT_EQ(chosen.numbers.at("tree"), (std::vector<double>{2, 1, 2, 1, 2, 1, 2, 1}));
    EXPECT_EQ(chosen.numbers.at("time"), (std::vector<double>{0, 0, 2, 2, 4, 4, 6, 6}));
    const Rows all = rows({"--tops"});
    EXPECT_EQ(chosen.numbers.at("top_x")[2], all.numbers.at("top_x")[10 * 3 + 2]) << "the motion is the same";
}

/// Moments of the steady wind turn the trees downwind, and the parts fit together.
TEST_F(SimulateTables, LoadsHaveTheSignsOfTheWind) {
    const Rows trees = rows({"--loads"}), feet = rows({"--loads", "--units", "0"});
    EXPECT_EQ(trees.header,
              "time,tree,wind_x,wind_y,wind_z,shift_x,shift_y,velocity_x,velocity_y,lean,moment_x,"
              "moment_y,weight_moment_x,weight_moment_y,limit,frequency,id");
    EXPECT_EQ(feet.header,
              "time,tree,unit,moment_x,moment_y,moment_z,strain_x,strain_y,strain_z,tilt_x,tilt_y,"
              "tilt_z,limit,id");
    ASSERT_EQ(trees.size(), 3u * 31u);
    const std::size_t last = trees.size() - 3; // the spruce
    EXPECT_NEAR(trees.numbers.at("wind_x")[last], 12.0, 1e-3);
    EXPECT_GT(trees.numbers.at("shift_x")[last], 0.1);
    EXPECT_GT(trees.numbers.at("moment_x")[last], 1e4);
    EXPECT_GT(trees.numbers.at("weight_moment_x")[last], 0.0);
    EXPECT_GT(feet.numbers.at("strain_x")[last], 1e-5);
    EXPECT_GT(feet.numbers.at("tilt_x")[last], 1e-4);
    for (std::size_t i = 0; i < trees.size(); ++i) {
        for (const char* same : {"moment_x", "moment_y", "limit"})
            EXPECT_NEAR(trees.numbers.at(same)[i], feet.numbers.at(same)[i],
                        1e-4 * std::abs(trees.numbers.at("moment_x")[i]) + 0.01);
    }
}

TEST_F(SimulateTables, NetCdfHasTheValuesOfTheCsv) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"--tops"}, {"--loads"}, {"--loads", "--units", "3,0"}, {"--tips"}}) {
        SCOPED_TRACE(words.back());
        std::vector<std::string> toFile = words;
        toFile.insert(toFile.end(), {"-o", "motion.nc"});
        const Outcome outcome = simulate(toFile);
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        const NetCdf file(at("motion.nc"));
        const Rows csv = rows(words);
        const bool ofTrees = words.back() == "--tops" || words.back() == "--loads";
        for (const auto& [name, numbers] : csv.numbers) {
            if (name == "time" || name == "tree" || name == "unit" || name == "level")
                continue;
            const std::vector<std::string> dimensions = file.dimensionsOf(name);
            EXPECT_EQ(dimensions.back(), ofTrees ? "tree" : "unit");
            EXPECT_EQ(dimensions.size(), name.rfind("rest", 0) == 0 ? 1u : 2u);
            EXPECT_FALSE(file.text(name, "units").empty());
            EXPECT_FALSE(file.text(name, "long_name").empty());
            const std::vector<double> written = file.numbers(name);
            ASSERT_EQ(written.size() * (dimensions.size() == 1 ? 31 : 1), numbers.size()) << name;
            for (std::size_t i = 0; i < written.size(); ++i) {
                if (std::isnan(written[i]) && std::isnan(numbers[i]))
                    continue;
                EXPECT_NEAR(written[i], numbers[i], 1e-5 * std::abs(numbers[i]) + 1e-6) << name;
            }
        }
        EXPECT_EQ(file.texts("id"), (std::vector<std::string>{"old, tall", "0", ""}));
        EXPECT_EQ(file.numbers("x"), (std::vector<double>{500010, 500040, 500070}));
        EXPECT_EQ(file.text("x", "standard_name"), "projection_x_coordinate");
        EXPECT_EQ(file.text("crs", "epsg_code"), "EPSG:25832");
        EXPECT_EQ(file.text("time", "units"), "seconds since 2024-03-05 12:00:00");
        EXPECT_NEAR(file.numbers("time").at(1), 0.7, 1e-9) << "time 0 is half a second past noon";
        if (!ofTrees) {
            EXPECT_EQ(file.text("tree_index", "instance_dimension"), "tree");
            EXPECT_EQ(file.numbers("unit_number").at(1), csv.numbers.at("unit")[1]);
        }
    }
}

TEST_F(SimulateTables, TimeHasNoDateWhereTheWindHasNone) {
    ASSERT_EQ(runTool({"simulate", example("forest.treewind"), "--duration", "0", "--tops", "-o", "a.nc"},
                      folder.path())
                  .exitCode,
              0);
    EXPECT_EQ(NetCdf(at("a.nc")).text("time", "units"), "s");
}

TEST_F(SimulateTables, FallenTreesHaveNoLoads) {
    folder.write("storm.treewind",
                 "version = 1\n[motion]\ndamage = true\n[wind]\nkind = \"uniform\"\n"
                 "velocity = [40, 0, 0]\n[[tree]]\nspecies = \"Norway spruce\"\nheight = 20\n"
                 "position = [0, 0]\n");
    const Outcome storm = runTool({"simulate", "storm.treewind", "--loads", "--duration", "30", "--fps", "5",
                                   "--plot", "fall.svg", "-o", "-"},
                                  folder.path());
    ASSERT_EQ(storm.exitCode, 0) << storm.err;
    const Rows loads(storm.out);
    EXPECT_GT(loads.numbers.at("moment_x").at(50), 0.0);
    EXPECT_TRUE(std::isnan(loads.numbers.at("moment_x").back()));
    EXPECT_NE(contentOf(at("fall.svg")).find("</svg>"), std::string::npos);
}

/// In a steady wind, trees keep the sway that they have at time 0.
TEST_F(SimulateTables, TreesSwayInTheirWindFromTheStart) {
    folder.write("steady.treewind",
                 "version = 1\n[wind]\nkind = \"uniform\"\nvelocity = [12, 0, 0]\n[[tree]]\n"
                 "species = \"Norway spruce\"\nheight = 20\nposition = [0, 0]\n");
    const Outcome steady =
        runTool({"simulate", "steady.treewind", "--loads", "--duration", "10", "--fps", "10"}, folder.path());
    ASSERT_EQ(steady.exitCode, 0) << steady.err;
    const Rows loads(steady.out);
    const std::vector<double>& moments = loads.numbers.at("moment_x");
    ASSERT_EQ(moments.size(), 101u);
    for (const double moment : moments)
        EXPECT_NEAR(moment, moments.back(), 0.01 * moments.back());
}

TEST_F(SimulateTables, PlotsTheFirstTree) {
    std::string gusty = contentOf(at("wood.treewind"));
    folder.write("wood.treewind", gusty.insert(gusty.find("[[tree]]"), "intensity = 0.3\n"));
    const Outcome svg =
                      simulate({"--plot", "a.svg", "--trees", "old, tall"}), // a list: no tree has the id old
        first = simulate({"--plot", "a.svg"});
    EXPECT_EQ(svg.exitCode, 2);
    EXPECT_EQ(first.exitCode, 0) << first.err;
    EXPECT_EQ(first.out, "") << "without -o there is no table";
    EXPECT_NE(contentOf(at("a.svg")).find("</svg>"), std::string::npos);
    const Outcome png = simulate({"--plot", "a.png"});
    EXPECT_EQ(png.exitCode, 0) << png.err;
    const osg::ref_ptr<osg::Image> picture = pictureIn(folder, "a.png");
    const auto blueBetween = [&](int from, int to) { // pixels of the lines
        int count = 0;
        for (int y = 0; y < picture->t(); ++y)
            for (int x = from; x < to; ++x) {
                const osg::Vec4 colour =
                    picture->getColor(static_cast<unsigned>(x), static_cast<unsigned>(y));
                count += colour.b() > colour.r() + 0.3f;
            }
        return count;
    };
    ASSERT_EQ(picture->s(), 1100);
    EXPECT_GT(blueBetween(90, 460), 20) << "path";
    EXPECT_GT(blueBetween(560, 1070), 100) << "moment";
    EXPECT_EQ(blueBetween(470, 550), 0);
}

/// The disk is full after 100 kB: the last line of output is the error, and the old file stays.
TEST_F(SimulateTables, AFullDiskLeavesTheOldFile) {
    folder.write("motion.nc", "old");
    const Outcome outcome = runShell("trap '' XFSZ; ulimit -f 100; " OSGTREEWIND_TOOL
                                     " simulate wood.treewind --tips --duration 10 --fps 20 -o motion.nc",
                                     folder.path());
    EXPECT_EQ(outcome.exitCode, 1);
    const std::string error = "motion.nc: cannot be written: File too large\n";
    EXPECT_EQ(outcome.err.find(error), outcome.err.size() - error.size()) << outcome.err;
    EXPECT_EQ(contentOf(at("motion.nc")), "old");
}

TEST_F(SimulateTables, RefusesInvalidOptions) {
    for (const auto& [words, message] :
         {std::pair<std::vector<std::string>, const char*>{{"--tops", "--loads"}, "--tops excludes --loads"},
          {{"--tops", "--tips"}, "excludes"},
          {{"--damage", "--every", "2"}, "excludes"},
          {{"--damage", "-o", "a.nc"}, "--output: --damage is written as CSV"},
          {{"--units", "0"}, "--units requires --loads"},
          {{"--loads", "--units", "0,9999"}, "--units: expected numbers below "},
          {{"--every", "0"}, "--every"},
          {{"--trees", "3"},
           "--trees: expected the id of a tree in wood.treewind or a number below 3, found 3"},
          {{"--trees", "1x"}, "found 1x"},
          {{"--plot", "a.pdf"}, "--plot: expected a name that ends in .svg or .png, found a.pdf"},
          {{"-o", "absent/a.nc"}, "absent/a.nc: cannot be written: there is no folder absent"}}) {
        const Outcome outcome = simulate(words);
        EXPECT_NE(outcome.exitCode, 0) << message;
        EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
    for (const char* option : {"--loads", "--plot=a.svg"}) {
        const Outcome thesis = runTool({"simulate", example("thesis.treewind"), option}, folder.path());
        EXPECT_EQ(thesis.exitCode, 2);
        EXPECT_NE(thesis.err.find("expects the law \"modal\""), std::string::npos) << thesis.err;
    }
    EXPECT_FALSE(std::filesystem::exists(at("a.svg")));
}
