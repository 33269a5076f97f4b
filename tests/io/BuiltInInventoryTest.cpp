// SPDX-License-Identifier: MIT
#include "TemporaryFolder.h"

#include <osgTreeWind/io/ForestFile.h>

#include <gtest/gtest.h>

#include <sstream>

namespace osgTreeWind {

TEST(BuiltInInventory, NamesNoSpeciesHasAreBuiltInOrTheDefault) {
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
    ASSERT_EQ(forest.value().notes.size(), 1u);
    EXPECT_NE(forest.value().notes[0].find("moon tree (2)"), std::string::npos);
    EXPECT_FLOAT_EQ(forest.value().gain, 2.5f);
}

} // namespace osgTreeWind
