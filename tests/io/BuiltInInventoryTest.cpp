// SPDX-License-Identifier: MIT
#include <tests/base/IsProblem.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/io/ForestFile.h>

#include <gtest/gtest.h>

#include <sstream>

namespace osgTreeWind {

TEST(BuiltInInventory, UnknownNamesAreBuiltInSpeciesOrTheDefault) {
    const TemporaryFolder folder;
    folder.write("a.csv",
                 "x,y,s\n1,2,Picea abies\n3,4,OAK\n5,6,moon tree\n7,8,Fagus sylvatica\n9,9,moon tree\n");
    std::istringstream input(
        "version = 1\n[motion]\ngain = 2.5\n[[species]]\nname = \"mine\"\naliases = [\"oak\"]\n"
        "[inventory]\nfile = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", species = \"s\" }\n"
        "default_species = \"broadleaf\"\n");
    const auto forest = readForest(input, {"test.treewind", folder.path()});
    ASSERT_TRUE(forest.ok()) << forest.problems().front().text();
    std::vector<std::string> names;
    for (const TreePlacement& tree : forest.value().trees)
        names.push_back(forest.value().species[tree.species].name);
    EXPECT_EQ(names, (std::vector<std::string>{"Norway spruce", "mine", "broadleaf", "beech", "broadleaf"}));
    ASSERT_EQ(forest.value().notes.size(), 2u) << "the other is about sizes";
    EXPECT_TRUE(hasPart(forest.value().notes[0], "moon tree (2)"));
    EXPECT_FLOAT_EQ(forest.value().gain, 2.5f);
}

TEST(BuiltInSpeciesOfTrees, NeedNoDeclaration) {
    std::istringstream input("version = 1\n[[tree]]\nspecies = \"oak\"\nposition = [0, 0]\n"
                             "[[tree]]\nspecies = \"Picea abies\"\nposition = [9, 0]\n"
                             "[scatter]\ncount = 5\narea = [20, 0, 60, 40]\nspecies = [\"Oak\"]\n");
    const auto forest = readForest(input);
    ASSERT_TRUE(forest.ok()) << forest.problems().front().text();
    const auto name = [&](std::size_t tree) {
        return forest.value().species[forest.value().trees[tree].species].name;
    };
    ASSERT_EQ(forest.value().species.size(), 2u) << "the unused default is removed";
    EXPECT_EQ(name(0), "oak");
    EXPECT_EQ(name(1), "Norway spruce");
    EXPECT_EQ(name(6), "oak");
    EXPECT_GT(forest.value().species[0].wood.crownDrag, 0.0f);
}

TEST(BuiltInSpeciesOfTrees, AreFoundByAllTheirNames) {
    std::istringstream input("version = 1\n[[tree]]\nspecies = \"Quercus robur\"\nposition = [0, 0]\n"
                             "[[tree]]\nspecies = \"English oak\"\nposition = [9, 0]\n");
    const auto forest = readForest(input);
    ASSERT_TRUE(forest.ok()) << forest.problems().front().text();
    EXPECT_EQ(forest.value().species.size(), 1u);
}

TEST(BuiltInSpeciesOfTrees, AreOverriddenByTheFile) {
    std::istringstream input("version = 1\n[[species]]\nname = \"Oak\"\nshapes = 7\n"
                             "[[tree]]\nspecies = \"English oak\"\nposition = [9, 0]\n");
    const auto forest = readForest(input);
    ASSERT_TRUE(forest.ok()) << forest.problems().front().text();
    ASSERT_EQ(forest.value().species.size(), 1u);
    EXPECT_EQ(forest.value().species[0].shapes, 7);
}

TEST(BuiltInSpeciesOfTrees, AreNotSpeciesOfTheFile) {
    std::istringstream input("version = 1\n[[tree]]\nspecies = \"oak\"\nposition = [0, 0]\n"
                             "[[tree]]\nposition = [9, 0]\n"
                             "[scatter]\ncount = 5\narea = [20, 0, 60, 40]\n");
    const auto forest = readForest(input);
    ASSERT_TRUE(forest.ok()) << forest.problems().front().text();
    for (std::size_t tree = 1; tree < 7; ++tree)
        EXPECT_EQ(forest.value().species[forest.value().trees[tree].species].name, "tree");
}

} // namespace osgTreeWind
