// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/modal/ModalKernel.h>
#include <osgTreeWind/motion/modal/ModalModel.h>
#include <osgTreeWind/species/Species.h>

#include <memory>
#include <tuple>
#include <vector>

namespace osgTreeWind {

/// What a tree is to the law `modal`: a form grown to a size, with a share of its leaves.
struct SwayingTree {
    const TreeModel* model = nullptr;
    const Species* species = nullptr;
    TreeScale scale;
    float leaves = 1.0f; ///< [0, 1]
};

/// A rung of size: trees near it share one archetype. Rungs do not depend on which trees there are.
struct ArchetypeRung {
    const TreeModel* model = nullptr;
    const Species* species = nullptr;
    /// Steps of height, of weight times length over the stiffness of wood, of crown width over height, of the
    /// leaves' share.
    int height = 0, support = 0, width = 0, leaves = 0;

    bool operator<(const ArchetypeRung& o) const {
        return std::tie(model, species, height, support, width, leaves) <
               std::tie(o.model, o.species, o.height, o.support, o.width, o.leaves);
    }
};

/// The rung nearest to a tree: heights a factor of 2 apart, so girths over them of 1.42, widths of 1.22,
/// leaves by quarters.
ArchetypeRung nearestRung(const SwayingTree& tree);
/// The tree that stands on a rung.
SwayingTree treeOn(const ArchetypeRung& rung);

/// Models of one tree at each level of detail, and what it takes to fit them to others. Immutable.
///
/// Modes keep their angles on another tree; their stiffness and mass follow its sizes by the powers found on
/// the archetype (Rayleigh's quotient: what changing angles would do to the pace is of second order).
class Archetype {
public:
    /// Modes of exactly this tree, which need not stand on a rung. Works on ModalDetail()s that suit trees
    /// near by and far away.
    explicit Archetype(const SwayingTree& tree);

    /// 0: near. 1: far.
    static constexpr std::size_t levels = 2;
    static constexpr ModalDetail details[levels] = {{12, 12}, {4, 4}};
    const ModalModel& model(std::size_t level) const { return _models[level]; }
    /// Nearest patch of the other level to each patch of `level`.
    const std::vector<std::size_t>& otherPatches(std::size_t level) const { return _other[level]; }

    /// Factors of another tree of the same model and species.
    TreeFactors factors(const SwayingTree& tree, float heading) const;
    /// Scale of the tree it was made from.
    const TreeScale& scale() const { return _scale; }

private:
    TreeScale _scale;
    float _leaves, _leafArea;
    SizePowers _logs; ///< Logarithms of what its growth gives it.
    std::vector<ModalModel> _models;
    std::vector<std::size_t> _other[levels];
};

/// That of a tree: the same one for all in the process who hold it, where the tree's model is shared
/// (TreeModel::identity). Any thread.
std::shared_ptr<const Archetype> sharedArchetype(const SwayingTree& tree);

} // namespace osgTreeWind
