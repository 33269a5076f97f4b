// SPDX-License-Identifier: MIT
#include <tests/Folders.h>
#include <tests/base/IsProblem.h>

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
    for (const auto& [text, place, part] :
         {std::tuple("[[species]]\nname = \"oak\"\n[species.wood]\ndensity = -1\n",
                     "5:11: species.wood.density", "found -1"),
          {"[[species]]\nname = \"my oak\"\naliases = [\"OAK\"]\n", "4:11: species.aliases",
           "\"OAK\" is taken"},
          {"[[species]]\nname = \"a\"\n[[species]]\nname = \"A\"\n", "5:8: species.name", "\"A\" is taken"},
          {"[[species]]\nname = \"a\"\nlike = \"lamp post\"\n", "4:8: species.like", "\"lamp post\""},
          {"[[tree]]\nposition = [0, 0]\n", "2:3: tree", "known here: group, species, version"}})
        EXPECT_TRUE(isProblem(problemOf(text), std::string("species.treewind:") + place, part));
    EXPECT_TRUE(hasPart(problemOf("[[species]\n"), "not valid TOML"));
}

} // namespace osgTreeWind
