// SPDX-License-Identifier: MIT
#include <tests/Folders.h>
#include <tests/FullTests.h>
#include <tests/base/IsProblem.h>
#include <tests/io/RandomForest.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/forest/CheckForest.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/wind/FunctionWind.h>
#include <osgTreeWind/wind/StreamedWind.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <sstream>

namespace osgTreeWind {

namespace {

/// Collects the keys in which two forests differ.
struct Differences {
    std::string keys;

    template <typename T>
    void compare(const std::string& key, const T& a, const T& b) {
        if (!(a == b))
            keys += key + ' ';
    }
    template <typename Struct>
    void fields(const std::string& path, const Struct& a, const Struct& b) {
        for (const Key& each : keysOf<Struct>())
            if (!isKeyEqual(each, &a, &b))
                keys += path + '.' + each.name + ' ';
    }
    template <typename Struct>
    void optionalFields(const std::string& path, const std::optional<Struct>& a,
                        const std::optional<Struct>& b) {
        compare(path, a.has_value(), b.has_value());
        if (a && b)
            fields(path, *a, *b);
    }

    void species(const std::string& path, const Species& a, const Species& b) {
        compare(path + ".name", a.name, b.name);
        fields(path, a, b);
        fields(path + ".tree", a.tree.wood, b.tree.wood);
        optionalFields(path + ".palm", a.tree.palm, b.tree.palm);
        optionalFields(path + ".habit", a.tree.growth, b.tree.growth);
        fields(path + ".leaves", a.tree.leaves, b.tree.leaves);
        compare(path + ".scan", a.tree.scans ? a.tree.scans->size() : 0,
                b.tree.scans ? b.tree.scans->size() : 0);
    }

    template <typename Wind>
    static bool areBoth(const WindFieldPtr& a, const WindFieldPtr& b, const Wind*& left, const Wind*& right) {
        left = dynamic_cast<const Wind*>(a.get()), right = dynamic_cast<const Wind*>(b.get());
        return left && right;
    }
    void wind(const Wind& a, const Wind& b) {
        field(a.field, b.field);
        fields("wind.gusts", a.gusts, b.gusts);
        fields("wind.clock", a.clock, b.clock);
        fields("wind.adjustment", a.adjustment, b.adjustment);
        compare("wind.source", a.sources.size(), b.sources.size());
        for (std::size_t i = 0; i < std::min(a.sources.size(), b.sources.size()); ++i)
            fields("wind.source", a.sources[i], b.sources[i]);
        if (!a.isCalm())
            compare("wind.frame", a.frame, b.frame);
    }
    void field(const WindFieldPtr& a, const WindFieldPtr& b) {
        if (!a || !b)
            return compare("wind", a, b);
        if (const UniformWind * x, *y; areBoth(a, b, x, y)) {
            compare("wind.velocity", x->velocity(), y->velocity());
            optionalFields("wind", x->profile(), y->profile());
        } else if (const GridWind * x, *y; areBoth(a, b, x, y)) {
            fields("wind", x->grid(), y->grid());
        } else if (const ThesisWind * x, *y; areBoth(a, b, x, y)) {
            fields("wind", x->array(), y->array());
        } else if (const TimeSeriesWind * x, *y; areBoth(a, b, x, y)) {
            fields("wind", x->series(), y->series());
            optionalFields("wind", x->series().profile, y->series().profile);
        } else {
            keys += "wind.kind ";
        }
    }
};

std::string differenceOf(const ForestDescription& a, const ForestDescription& b) {
    Differences found;
    found.fields("motion", a, b);
    found.fields("drawing", a.drawing, b.drawing);
    found.compare("noise", a.noiseExponent, b.noiseExponent);
    found.compare("season", a.season, b.season);
    found.compare("step", a.step, b.step);
    found.compare("crs", a.crs, b.crs);
    found.compare("origin", a.origin, b.origin);
    found.wind(a.wind, b.wind);
    found.compare("species", a.species.size(), b.species.size());
    found.compare("trees", a.trees.size(), b.trees.size());
    if (!found.keys.empty())
        return found.keys;
    for (std::size_t i = 0; i < a.species.size(); ++i)
        found.species("species", a.species[i], b.species[i]);
    for (std::size_t i = 0; i < a.trees.size(); ++i) {
        found.fields("tree", a.trees[i], b.trees[i]);
        found.compare("tree.species", a.trees[i].species, b.trees[i].species);
        found.compare("tree.position", a.trees[i].position, b.trees[i].position);
    }
    return found.keys;
}

std::string written(const ForestDescription& forest) {
    std::ostringstream output;
    for (const Diagnostic& problem : writeForest(forest, output))
        ADD_FAILURE() << problem.text();
    return output.str();
}

ForestDescription read(const std::string& document) {
    std::istringstream input(document);
    const auto forest = readForest(input, {"forest", "/"});
    for (const Diagnostic& problem : forest ? Diagnostics() : forest.problems())
        ADD_FAILURE() << problem.text() << "\n" << document.substr(0, 20000);
    return forest ? forest.value() : ForestFile();
}

/// The first problem that keeps a forest from being written.
std::string refusalOf(const ForestDescription& forest) {
    std::ostringstream output;
    const Diagnostics problems = writeForest(forest, output);
    EXPECT_EQ(output.str(), "");
    return problems.empty() ? "" : problems.front().text();
}

ForestDescription smallForest() {
    ForestDescription forest;
    forest.species.emplace_back().name = "oak";
    forest.trees.emplace_back();
    return forest;
}

} // namespace

TEST(WriteForest, RandomDescriptionsReadBack) {
    for (int seed = 0; seed < casesToRun(2000, 300); ++seed) {
        const ForestDescription forest = RandomForest(static_cast<std::uint64_t>(seed)).description();
        const std::string document = written(forest);
        ASSERT_EQ(differenceOf(read(document), forest), "") << "seed " << seed << '\n' << document;
        ASSERT_FALSE(HasFailure()) << "seed " << seed;
    }
}

TEST(WriteForest, RandomDocumentsReadBack) {
    for (int seed = 0; seed < casesToRun(2000, 300); ++seed) {
        const std::string document = RandomForest(static_cast<std::uint64_t>(seed)).document();
        const ForestDescription forest = read(document);
        ASSERT_FALSE(HasFailure()) << "seed " << seed << '\n' << document;
        ASSERT_EQ(differenceOf(read(written(forest)), forest), "") << "seed " << seed << '\n' << document;
    }
}

TEST(WriteForest, ExamplesReadBack) {
    for (const char* example : {"forest", "thesis"}) {
        const auto forest =
            readForestFile(OSGTREEWIND_SOURCE_DIR "/examples/" + std::string(example) + ".treewind");
        ASSERT_TRUE(forest.ok());
        EXPECT_EQ(differenceOf(read(written(forest.value())), forest.value()), "") << example;
    }
}

TEST(WriteForest, BuiltInSpeciesReadBack) {
    ForestDescription forest;
    forest.species = SpeciesCatalogue::builtIn().species();
    EXPECT_EQ(differenceOf(read(written(forest)), forest), "");
}

TEST(WriteForest, PathsOfScansPicturesAndWindReadBack) {
    const std::string data = OSGTREEWIND_TEST_DATA;
    const TemporaryFolder folder;
    folder.write("leaf.png", "no picture, but there");
    folder.write("wind.csv", "time,u,v\n0,1,2\n10,3,4\n");
    folder.write("a.treewind",
                 "version = 1\norigin = [5, 6, 7]\n[[species]]\nname = \"a\"\nscan = [\"" + data +
                     "/scan/treeqsm.txt\", \"" + data +
                     "/scan/treeqsm.txt\"]\nup = \"z\"\nappearance.leaf_image = \"leaf.png\"\n[[tree]]\n"
                     "position = [0, 0]\n[wind]\nkind = \"file\"\nfile = \"wind.csv\"\nstart = 5\n");
    const auto forest = readForestFile(folder.path() + "/a.treewind");
    ASSERT_TRUE(forest.ok()) << forest.problems().front().text();
    const std::string document = written(forest.value());
    const ForestDescription back = read(document);
    ASSERT_EQ(back.species.size(), 1u) << document;
    EXPECT_EQ(back.species[0].tree.scans->size(), 2u);
    EXPECT_EQ(back.species[0].tree.scans->back().report.up, "z");
    EXPECT_EQ(back.species[0].appearance.leafImage, folder.path() + "/leaf.png");
    EXPECT_EQ(asField(back.wind)->velocity({}, 1.0), asField(forest.value().wind)->velocity({}, 1.0));
    EXPECT_EQ(written(back), document);
}

TEST(WriteForest, AcceptsAForestWithoutTrees) {
    ForestDescription forest = smallForest();
    forest.trees.clear();
    EXPECT_EQ(differenceOf(read(written(forest)), forest), "");
}

TEST(WriteForest, ReportsWhatCannotBeWritten) {
    const auto refused = [](const char* key, const char* part, auto spoil) {
        ForestDescription forest = smallForest();
        spoil(forest);
        EXPECT_TRUE(isProblem(refusalOf(forest), key, part));
    };
    refused("species[0].wood.density", "found 0", [](auto& f) { f.species[0].wood.density = 0; });
    refused("species[0].palm.inclination", "[0, 180] degrees, found nan", [](auto& f) {
        f.species[0].tree.palm.emplace().inclination = std::numeric_limits<float>::quiet_NaN();
    });
    refused("species[0].tree.radius", "half the trunk",
            [](auto& f) { f.species[0].tree.wood.radius = 5.0f; });
    refused("drawing.impostor", "found 250 and 250", [](auto& f) { f.drawing.impostor = 250.0f; });
    refused("crs", "found WGS 84, which uses degrees", [](auto& f) { f.crs = "EPSG:4326"; });
    refused("tree[0].species", "no species 3", [](auto& f) { f.trees[0].species = 3; });
    refused("tree[0].position", "100 km from the origin", [](auto& f) { f.origin.x = 2e5; });
    refused("tree[1].id", "\"7\" is taken", [](auto& f) {
        f.trees[0].name = "7";
        f.trees.push_back(f.trees[0]);
    });
    refused("species[1].name", "\"OAK \" is taken", [](auto& f) {
        f.species.push_back(f.species[0]);
        f.species[1].name = "OAK ";
    });
    refused("species[0].name", "missing", [](auto& f) { f.species[0].name.clear(); });
    refused("species[0].appearance", "no file \"/no.png\"",
            [](auto& f) { f.species[0].appearance.barkImage = "/no.png"; });
    refused("species[0].scan", "scan 0 was not read from a file", [](auto& f) {
        const ScannedTree scan = makeScannedTree({{{0, 0, 0}, {0, 0, 5}, 0.1, -1, 0}}).value();
        f.species[0].tree.scans = std::make_shared<const std::vector<ScannedTree>>(1, scan);
        f.species[0].shapes = 1;
    });
    refused("wind", "not a callable or streamed one",
            [](auto& f) { f.wind = std::make_shared<FunctionWind>(nullptr); });
    refused("wind", "velocity: expected a finite number in [-200, 200]",
            [](auto& f) { f.wind = std::make_shared<UniformWind>(glm::vec3(201, 0, 0)); });
}

TEST(WriteForest, ReportsAFileThatCannotBeWritten) {
    EXPECT_TRUE(isProblem(writeForestFile(smallForest(), "/nowhere/a.treewind").front().text(),
                          "/nowhere/a.treewind", "there is no folder /nowhere"));
}

TEST(WriteForest, BuiltInSpeciesAreValid) {
    ForestDescription forest;
    forest.species = SpeciesCatalogue::builtIn().species();
    const Diagnostics problems = check(forest);
    EXPECT_TRUE(problems.empty()) << problems.front().text();
}

} // namespace osgTreeWind
