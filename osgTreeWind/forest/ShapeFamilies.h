// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/model/TreeModel.h>

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// The shapes that a forest grows. Those of a species are of families: for the company that its trees stand
/// in, a forest, its edge or the open, and for their heights, where it grows by light: small, middling and
/// large ones, in steps of a quarter. All families of a species together have as many shapes as it is to
/// have, and one each at least; those with many trees have more. A species whose trees grow alike has one
/// family, and one without trees is grown for the forest.
class ShapeFamilies {
public:
    explicit ShapeFamilies(const ForestDescription& forest);

    /// The next species, whose trees stand in a forest, in the open or both.
    void add(const Species& species, bool inForest, bool inOpen);

    struct Family {
        std::size_t species = 0; ///< Index into ForestDescription::species.
        bool openGrown = false;  ///< TreePlacement::openGrown,
        bool atEdge = false;     ///< and atEdge of its trees.
        float height = 0.0f;     ///< To which they grow, metres; 0: the species does not say.
        TreeParameters tree;
        std::uint32_t shapes = 1; ///< A tree's seed modulo that is its own.
    };
    /// By species.
    const std::vector<Family>& all() const { return _all; }
    /// Index of that of a tree: of its company, or of another one where no tree stood in its own; and of the
    /// height nearest to its own.
    std::size_t indexOf(const TreePlacement& tree) const;
    /// countLargest() of each, grown on the threads of the process.
    std::vector<TreeCounts> countLargest() const;

private:
    enum Company { InForest, AtEdge, InOpen };
    /// Trees of a species that stand in one company.
    struct Stand {
        std::map<int, std::size_t> trees; ///< How many, by their heights in steps from the usual one.
        bool usual = false;               ///< Some have that one, since theirs is not given.
        std::vector<std::pair<int, TreeSize>> sizes; ///< Those that are given, with their steps.
    };
    using Stands = std::array<Stand, 3>;

    static Company companyOf(const TreePlacement& tree, const Species& species);
    static void proportion(Family& family, const Species& species, Stand& stand, int at);
    static void addUsual(Stand& stand); ///< A tree of that height.
    void add(const Species& species, Stands stands);

    std::vector<Family> _all;
    std::vector<std::pair<std::size_t, std::size_t>> _ofSpecies; ///< The first, and the one after the last.
    std::vector<float> _usualHeights;                            ///< By species.
};

} // namespace osgTreeWind
