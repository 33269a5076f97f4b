// SPDX-License-Identifier: MIT
#include <tests/base/IsProblem.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace osgTreeWind {

namespace {

const std::string document = "# Wäldchen am Fluß\n"
                             "version = 1\n"
                             "seed = 5\n"
                             "season = \"summer\" # see the calendar\n"
                             "\n"
                             "[wind] # of the mast\n"
                             "kind = \"uniform\"\n"
                             "speed = 7.5   # ü ok\n"
                             "direction_from = 270.0\n"
                             "\n"
                             "# Our trees\n"
                             "[inventory]\n"
                             "file = \"trees.csv\" # beside this\n"
                             "columns = { x = \"x\", y = \"y\" }\n"
                             "\n"
                             "[[species]] # all of them\n"
                             "name = \"oak\"\n";

/// A file, and the description of a running forest that was read from it.
class EditForestTest : public ::testing::Test {
protected:
    EditForestTest() {
        _folder.write("trees.csv", "x,y\n1.1,2.3\n3,4\n5,6\n");
        file = _folder.write("wood.treewind", document);
        const auto read = readForestFile(file);
        EXPECT_TRUE(read) << toString(read.problems());
        now = ForestSimulation(read.value()).currentDescription();
    }

    std::string edit(const std::string& name = "edited.treewind") {
        const std::string path = (std::filesystem::path(file).parent_path() / name).string();
        EXPECT_EQ(toString(editForestFile(now, file, path)), "");
        std::stringstream text;
        text << std::ifstream(path, std::ios::binary).rdbuf();
        return text.str();
    }
    static std::string with(std::string text, const std::string& part, const std::string& other) {
        const std::size_t at = text.find(part);
        EXPECT_NE(at, std::string::npos) << part;
        return text.replace(at, part.size(), other);
    }
    ForestDescription again(const std::string& name = "edited.treewind") {
        const auto read = readForestFile((std::filesystem::path(file).parent_path() / name).string());
        EXPECT_TRUE(read) << toString(read.problems());
        return read ? read.value() : ForestFile();
    }

    TemporaryFolder _folder;
    std::string file;
    ForestDescription now;
};

} // namespace

TEST_F(EditForestTest, unchangedForestKeepsTheText) {
    EXPECT_EQ(edit(), document);
}

TEST_F(EditForestTest, changesAValueInPlace) {
    now.season = 3.0f;
    EXPECT_EQ(edit(), with(document, "season = \"summer\" # see", "season = 3 # see"));
}

TEST_F(EditForestTest, appendsANewKeyToItsTable) {
    now.wind.adjustment = {1.5, glm::radians(20.0f)};
    EXPECT_EQ(edit(), with(document, "direction_from = 270.0\n",
                           "direction_from = 270.0\nstrength = 1.5\nturn = 20\n"));
}

TEST_F(EditForestTest, appendsANewTable) {
    now.gain = 2.0f;
    EXPECT_EQ(edit(), document + "\n[motion]\ngain = 2\n");
}

TEST_F(EditForestTest, removesAKeyWithItsDefaultValue) {
    std::ofstream(file, std::ios::binary)
        << with(document, "seed = 5\n", "seed = 5\nmotion.gain = 2.0 # more\n");
    EXPECT_EQ(edit(), document);
}

TEST_F(EditForestTest, insertsSourcesAfterTheWind) {
    now.wind.sources.resize(2);
    const std::string two = edit("wood.treewind");
    EXPECT_EQ(two.find("[[wind.source]]"), two.find("270.0\n") + 7);
    EXPECT_EQ(two.substr(two.find("\n# Our")), document.substr(document.find("\n# Our")));
    now.wind.sources.resize(1);
    const std::string one = edit("wood.treewind");
    EXPECT_EQ(one.rfind("[[wind.source]]"), one.find("[[wind.source]]"));
    now.wind.sources.clear();
    EXPECT_EQ(edit().find("wind.source"), std::string::npos);
}

TEST_F(EditForestTest, replacesTheSectionForAnotherKindOfWind) {
    now.wind = std::make_shared<UniformWind>(glm::vec3(5.0f, 0.0f, 0.0f));
    now.wind.gusts.intensity = 0.2;
    const std::string text = edit();
    for (const char* kept :
         {"# Wäldchen am Fluß\n", "# see the calendar", "# Our trees\n", "# beside this", "# all"})
        EXPECT_TRUE(hasPart(text, kept)) << kept << " in\n" << text;
    EXPECT_EQ(again().wind.gusts.intensity, 0.2);
    EXPECT_LT(text.find("gusts"), text.find("# Our trees"));
}

TEST_F(EditForestTest, editsAFileInPlace) {
    now.season = 3.0f;
    edit("wood.treewind");
    now.season = 1.0f;
    EXPECT_EQ(edit("wood.treewind"), with(document, "season = \"summer\"", "season = 1"));
}

TEST_F(EditForestTest, changedTreesRewriteTheFile) {
    now.trees.pop_back();
    EXPECT_TRUE(hasPart(edit(), "[[tree]]"));
    EXPECT_EQ(again().trees.size(), 2u);
}

TEST_F(EditForestTest, anotherFolderKeepsPathsValid) {
    const TemporaryFolder other;
    const std::string path = other.path() + "/edited.treewind";
    now.season = 3.0f;
    ASSERT_EQ(toString(editForestFile(now, file, path)), "");
    const auto read = readForestFile(path);
    ASSERT_TRUE(read) << toString(read.problems());
    EXPECT_EQ(read.value().trees.size(), 3u);
    EXPECT_EQ(read.value().season, 3.0f);
}

TEST_F(EditForestTest, missingSourceIsWrittenAsANewFile) {
    std::filesystem::remove(file);
    EXPECT_TRUE(hasPart(edit(), "[[tree]]"));
}

} // namespace osgTreeWind
