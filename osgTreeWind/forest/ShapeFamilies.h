// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/model/TreeModel.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// The shapes that a forest grows: those of each species for the company its trees stand in, the open or the
/// forest, or both; only once where a species grows alike in both. A species without trees is grown for the
/// forest.
class ShapeFamilies {
public:
    explicit ShapeFamilies(const ForestDescription& forest);

    /// The next species, whose trees stand in a forest, in the open or both.
    void add(const Species& species, bool inForest, bool inOpen);

    struct Family {
        std::size_t species = 0; ///< Index into ForestDescription::species.
        bool openGrown = false;
        TreeParameters tree;
        std::uint32_t shapes = 1; ///< A tree's seed modulo that is its own.
    };
    /// By species.
    const std::vector<Family>& all() const { return _all; }
    /// Index of that of a tree: of its company, or of the other one where no tree stood in its own.
    std::size_t indexOf(std::size_t species, bool openGrown) const {
        return openGrown ? _ofSpecies[species].second : _ofSpecies[species].first;
    }
    std::size_t indexOf(const TreePlacement& tree) const { return indexOf(tree.species, tree.openGrown); }

    /// countLargest() of each, grown on the threads of the process.
    std::vector<TreeCounts> countLargest() const;

private:
    std::vector<Family> _all;
    std::vector<std::pair<std::size_t, std::size_t>> _ofSpecies; ///< In a forest, in the open.
};

} // namespace osgTreeWind
