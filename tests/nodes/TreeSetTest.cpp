// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/TreeSet.h>

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace osgTreeWind;

TEST(TreeSetTest, holdsEachTreeOnce) {
    TreeSet trees;
    for (int i = 0; i < 1000; ++i)
        trees.add(7);
    EXPECT_EQ(trees.size(), 1u);
    trees.remove(7);
    trees.remove(7);
    trees.remove(100);
    EXPECT_EQ(trees.size(), 0u);
    EXPECT_FALSE(trees.has(7));
}

TEST(TreeSetTest, isASetWhateverComesAndGoes) {
    TreeSet trees;
    std::set<std::uint32_t> expected;
    std::mt19937 random(3);
    for (int i = 0; i < 5000; ++i) {
        const std::uint32_t tree = random() % 64;
        if (random() % 2) {
            trees.add(tree);
            expected.insert(tree);
        } else {
            trees.remove(tree);
            expected.erase(tree);
        }
        ASSERT_EQ(trees.size(), expected.size());
    }
    trees.removeIf([](std::uint32_t tree) { return tree % 3 == 0; });
    for (std::uint32_t tree = 0; tree < 70; ++tree)
        EXPECT_EQ(trees.has(tree), tree % 3 != 0 && expected.count(tree) > 0) << tree;
}
