// SPDX-License-Identifier: MIT
#include <tests/Folders.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace osgTreeWind {

namespace {

Result<SpeciesCatalogue> hostsWith(const std::string& text) {
    return SpeciesCatalogue::builtIn().with("version = 1\n" + text, "species.treewind", "/nowhere");
}

SpeciesCatalogue hosts(const std::string& text) {
    const Result<SpeciesCatalogue> catalogue = hostsWith(text);
    EXPECT_TRUE(catalogue.ok()) << catalogue.problems().front().text();
    return catalogue.ok() ? catalogue.value() : SpeciesCatalogue::builtIn();
}

std::string problemOf(const std::string& text) {
    const Result<SpeciesCatalogue> catalogue = hostsWith(text);
    return catalogue.ok() ? "none" : catalogue.problems().front().text();
}

std::size_t ours() {
    return SpeciesCatalogue::builtIn().species().size();
}

} // namespace

TEST(SpeciesCatalogue, AppendsSpeciesOfTheFile) {
    const SpeciesCatalogue catalogue =
        hosts("[[species]]\nname = \"dragon tree\"\naliases = [\"Dracaena draco\"]\nlike = \"oak\"\n"
              "[species.wood]\ndensity = 1000\n");
    ASSERT_EQ(catalogue.species().size(), ours() + 1);
    EXPECT_EQ(catalogue.species().back().name, "dragon tree");
    const Species* tree = catalogue.find("dracaena DRACO");
    ASSERT_TRUE(tree);
    EXPECT_EQ(tree->name, "dragon tree");
    EXPECT_EQ(tree->wood.density, 1000.0f);
    EXPECT_EQ(tree->wood.elasticModulus, catalogue.find("oak")->wood.elasticModulus);
    EXPECT_EQ(catalogue.find("Ulmus minor")->name, "broadleaf");
    EXPECT_FALSE(SpeciesCatalogue::builtIn().find("dragon tree"));
}

TEST(SpeciesCatalogue, ReplacesASpeciesAndKeepsItsAliases) {
    const SpeciesCatalogue catalogue = hosts("[[species]]\nname = \"Oak\"\nlike = \"oak\"\n"
                                             "[species.wood]\ndensity = 1000\n");
    EXPECT_EQ(catalogue.species().size(), ours());
    EXPECT_EQ(catalogue.find("Quercus robur"), catalogue.find("OAK"));
    EXPECT_EQ(catalogue.find("oak")->wood.density, 1000.0f);
    EXPECT_EQ(catalogue.find("oak")->tree.growth->size.height,
              SpeciesCatalogue::builtIn().find("oak")->tree.growth->size.height);
}

TEST(SpeciesCatalogue, MovesAliasesToTheSpeciesOfTheFile) {
    const SpeciesCatalogue catalogue = hosts(
        "[[species]]\nname = \"blue spruce\"\naliases = [\"Picea pungens\"]\nlike = \"white spruce\"\n");
    EXPECT_EQ(catalogue.find("Picea pungens")->name, "blue spruce");
    EXPECT_EQ(catalogue.find("blue spruce")->name, "blue spruce");
    EXPECT_EQ(catalogue.find("Picea glauca")->name, "white spruce");
    EXPECT_EQ(catalogue.find("white spruce")->aliases, std::vector<std::string>{"Picea glauca"});
}

TEST(SpeciesCatalogue, GroupsAreOnlyForLike) {
    const SpeciesCatalogue catalogue =
        hosts("[[group]]\nname = \"my conifers\"\nlike = \"conifers\"\n[group.wood]\ndensity = 700\n"
              "[[species]]\nname = \"my fir\"\nlike = \"my conifers\"\n");
    EXPECT_FALSE(catalogue.find("my conifers"));
    EXPECT_TRUE(catalogue.findTemplate("my conifers"));
    EXPECT_EQ(catalogue.species().size(), ours() + 1);
    EXPECT_EQ(catalogue.find("my fir")->wood.density, 700.0f);
    EXPECT_EQ(catalogue.find("my fir")->wood.branchWood, WoodAllometry::Conifer);
}

TEST(SpeciesCatalogue, ReadsTheExampleOfTheManual) {
    std::ifstream file(OSGTREEWIND_SOURCE_DIR "/docs/species.md");
    const std::string manual{std::istreambuf_iterator<char>(file), {}}, open = "```toml\nversion = 1\n";
    const std::size_t start = manual.find(open, manual.find("## A catalogue of your own")) + open.size();
    const SpeciesCatalogue catalogue = hosts(manual.substr(start, manual.find("```", start) - start));
    EXPECT_EQ(catalogue.species().size(), ours() + 1);
    EXPECT_EQ(catalogue.find("Pinus pinea")->wood.branchModulus, 0.7f);
    EXPECT_EQ(catalogue.find("English oak")->wood.density, 1050.0f);
}

TEST(SpeciesCatalogue, ReportsProblemsWithTheirPosition) {
    EXPECT_EQ(
        problemOf("[[species]]\nname = \"oak\"\n[species.wood]\ndensity = -1\n"),
        "species.treewind:5:11: species.wood.density: expected a finite number in [1, 10000], found -1");
    EXPECT_EQ(problemOf("[[species]]\nname = \"my oak\"\naliases = [\"OAK\"]\n"),
              "species.treewind:4:11: species.aliases: the name \"OAK\" is taken already");
    EXPECT_EQ(problemOf("[[species]]\nname = \"a\"\n[[species]]\nname = \"A\"\n"),
              "species.treewind:5:8: species.name: the name \"A\" is taken already");
    EXPECT_EQ(problemOf("[[species]]\nname = \"a\"\nlike = \"lamp post\"\n"),
              "species.treewind:4:8: species.like: no built-in species \"lamp post\"");
    EXPECT_EQ(problemOf("[[tree]]\nposition = [0, 0]\n"),
              "species.treewind:2:3: tree: unknown key; known here: group, species, version");
    EXPECT_NE(problemOf("[[species]\n").find("not valid TOML"), std::string::npos);
}

} // namespace osgTreeWind
