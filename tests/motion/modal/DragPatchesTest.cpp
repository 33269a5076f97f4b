// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/DragPatches.h>

#include <tests/motion/GrownTree.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace osgTreeWind {
namespace {

using Patches = std::vector<std::size_t>;

/// Adds a link at the end of its parent, with drag at its midpoint.
std::size_t addLink(JointTree& tree, int parent, const glm::dvec3& base, const glm::dvec3& tip, double drag) {
    JointTree::Link link;
    link.parent = parent;
    link.base = base;
    tree.links.push_back(link);
    JointTree::Point point;
    point.link = tree.links.size() - 1;
    point.place = 0.5 * (base + tip);
    point.woodDrag = drag;
    tree.points.push_back(point);
    return point.link;
}

/// A trunk (link 0) with two boughs of two links each: 1 and 2, 3 and 4.
JointTree fork(double drag = 1.0) {
    JointTree tree;
    addLink(tree, -1, {0, 0, 0}, {0, 0, 5}, drag);
    for (const double side : {-1.0, 1.0}) {
        const auto bough = static_cast<int>(addLink(tree, 0, {0, 0, 5}, {2 * side, 0, 7}, drag));
        addLink(tree, bough, {2 * side, 0, 7}, {3 * side, 0, 8}, drag);
    }
    return tree;
}

TEST(DragPatches, CoverAllLinks) {
    const JointTree tree = GrownTree("oak", {18, 0.3f, 0}).joints();
    for (const std::size_t count : {1u, 2u, 4u, 10u, 28u}) {
        const Patches patches = dragPatches(tree, count);
        ASSERT_EQ(patches.size(), tree.links.size());
        const std::set<std::size_t> used(patches.begin(), patches.end());
        EXPECT_EQ(used.size(), count) << "patches without links";
        EXPECT_EQ(*used.rbegin(), count - 1);
    }
}

TEST(DragPatches, TheFirstPatchesAreCutAsForFewer) {
    const JointTree tree = GrownTree("Norway spruce", {18, 0.3f, 0}).joints();
    const Patches fine = dragPatches(tree, 20);
    for (std::size_t count = 1; count < 20; ++count) {
        const Patches coarse = dragPatches(tree, count);
        for (std::size_t i = 0; i < fine.size(); ++i) {
            if (fine[i] < count) {
                ASSERT_EQ(coarse[i], fine[i]) << "link " << i << " among " << count;
            }
            for (std::size_t j = 0; j < i; ++j)
                if (fine[i] == fine[j]) {
                    ASSERT_EQ(coarse[i], coarse[j]) << "links " << i << " and " << j << " among " << count;
                }
        }
    }
}

TEST(DragPatches, EachIsALinkWithItsDescendants) {
    const JointTree tree = GrownTree("beech", {18, 0.3f, 0}).joints();
    const Patches patches = dragPatches(tree, 12);
    std::vector<int> feet(12, 0); // links that start a patch
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const int parent = tree.links[i].parent;
        if (parent < 0 || patches[static_cast<std::size_t>(parent)] != patches[i])
            ++feet[patches[i]];
    }
    for (std::size_t p = 0; p < feet.size(); ++p)
        EXPECT_EQ(feet[p], 1) << "patch " << p << " is in pieces";
}

TEST(DragPatches, AForkIsCutIntoItsBoughs) {
    EXPECT_EQ(dragPatches(fork(), 2), (Patches{0, 1, 1, 0, 0}));
    EXPECT_EQ(dragPatches(fork(), 3), (Patches{0, 1, 1, 2, 2}));
}

TEST(DragPatches, OnePatchIsTheWholeTree) {
    EXPECT_EQ(dragPatches(fork(), 1), Patches(5, 0));
}

TEST(DragPatches, NeverOutnumberTheLinks) {
    const Patches patches = dragPatches(fork(), 30);
    EXPECT_EQ(std::set<std::size_t>(patches.begin(), patches.end()).size(), 5u);
    EXPECT_EQ(*std::max_element(patches.begin(), patches.end()), 4u);
}

TEST(DragPatches, WithoutDragThereIsOnePatch) {
    EXPECT_EQ(dragPatches(fork(0.0), 10), Patches(5, 0));
}

TEST(DragPatches, AnEmptyTreeHasNone) {
    EXPECT_TRUE(dragPatches(JointTree(), 10).empty());
}

} // namespace
} // namespace osgTreeWind
