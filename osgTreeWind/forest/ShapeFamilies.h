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

/// Plans which shapes a forest grows. The shapes of a species are grouped in families by growing space (in a
/// stand, at its edge, open-grown) and, for species that grow by light, by height: small, medium and large,
/// in height classes with a ratio of 1.25. The families of a species share its number of shapes in proportion
/// to their trees, with at least one shape each. A species without trees is grown for a stand.
class ShapeFamilies {
public:
    explicit ShapeFamilies(const ForestDescription& forest);

    /// Adds the next species, with trees in stands, open-grown trees or both.
    void add(const Species& species, bool inForest, bool inOpen);

    struct Family {
        std::size_t species = 0; ///< Index into ForestDescription::species.
        bool openGrown = false;  ///< TreePlacement::openGrown of its trees.
        bool atEdge = false;     ///< TreePlacement::atEdge of its trees.
        float height = 0.0f;     ///< To which it is grown, metres; 0: the species does not say.
        TreeParameters tree;
        std::uint32_t shapes = 1; ///< Number of shapes. A tree has the shape `seed % shapes`.
    };
    /// All families, ordered by species.
    const std::vector<Family>& all() const { return _all; }
    /// Index of the family that fits a tree: that of its growing space, or of another one if that has no
    /// family; then the one closest in height.
    std::size_t indexOf(const TreePlacement& tree) const;
    /// countLargest() of each family, grown on the thread pool of the process.
    std::vector<TreeCounts> countLargest() const;

private:
    enum GrowingSpace { InForest, AtEdge, Open };
    /// Trees of a species in one growing space.
    struct TreeGroup {
        std::map<int, std::size_t> trees; ///< Number of trees by height class; class 0 is the default height.
        bool hasDefaultHeight = false;    ///< The height of some trees is not given.
        std::vector<std::pair<int, TreeSize>> sizes; ///< Height classes and sizes of trees with given sizes.
    };
    using TreeGroups = std::array<TreeGroup, 3>;

    static GrowingSpace growingSpaceOf(const TreePlacement& tree, const Species& species);
    static void applyProportions(Family& family, const Species& species, TreeGroup& group, int at);
    static void addDefaultHeight(TreeGroup& group); ///< Adds a tree of the default height.
    /// Selects the height classes that become families, at most `maxFamilies` if their spaces allow it.
    static void selectClasses(TreeGroups& groups, bool bySize, std::size_t maxFamilies);
    void addFamily(const Species& species, TreeGroup& group, GrowingSpace space, int index);
    void add(const Species& species, TreeGroups groups);

    std::vector<Family> _all;
    std::vector<std::pair<std::size_t, std::size_t>> _familyRanges; ///< By species: first and past-the-end.
    std::vector<float> _defaultHeights;                             ///< By species.
};

} // namespace osgTreeWind
