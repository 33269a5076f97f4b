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

/// Input of the law `modal`: a tree model at a size, with a share of its leaves.
struct TreeForm {
    const TreeModel* model = nullptr;
    const Species* species = nullptr;
    TreeScale scale;
    float leaves = 1.0f; ///< [0, 1]
};

/// A size class, whose trees share one archetype. Classes do not depend on which trees there are.
struct TreeSizeClass {
    const TreeModel* model = nullptr;
    const Species* species = nullptr;
    /// Class numbers by height, by weight times length over wood stiffness, by width over height, by leaves.
    int height = 0, support = 0, width = 0, leaves = 0;

    bool operator<(const TreeSizeClass& o) const {
        return std::tie(model, species, height, support, width, leaves) <
               std::tie(o.model, o.species, o.height, o.support, o.width, o.leaves);
    }
};

/// The size class of a tree. Classes are a factor of 2 apart in height, 1.42 in girth over height and 1.22 in
/// width over height, and a quarter apart in leaves.
TreeSizeClass sizeClassOf(const TreeForm& tree);
/// The tree in the middle of a size class.
TreeForm typicalTree(const TreeSizeClass& sizeClass);

/// Modal models of one tree at each level of detail, with the factors that fit them to similar trees.
/// Immutable.
///
/// Another tree has the same mode shapes; modal stiffness and mass follow from its size by power laws found
/// on the archetype (Rayleigh quotient: the error of the frequency is of second order in the mode shapes).
class Archetype {
public:
    /// The modes are exact for this tree, which may have any size within its class.
    explicit Archetype(const TreeForm& tree);

    static constexpr std::size_t levels = 2; ///< 0: near, 1: far (ModalLevel).
    static constexpr ModalDetail details[levels] = {{12, 12}, {4, 4}};
    const ModalModel& model(std::size_t level) const { return _models[level]; }
    /// For each patch of `level`, the nearest patch of the other level.
    const std::vector<std::size_t>& otherPatches(std::size_t level) const { return _other[level]; }

    /// Factors for another tree of the same model and species.
    TreeFactors factors(const TreeForm& tree, float heading) const;
    /// Scale of the tree from which the archetype was made.
    const TreeScale& scale() const { return _scale; }

private:
    TreeScale _scale;
    float _leaves, _leafArea;
    SizePowers _logs; ///< Logarithms of its growth quantities.
    std::vector<ModalModel> _models;
    std::vector<std::size_t> _other[levels];
};

/// The archetype of exactly this tree; shared by all users in the process if the tree's model is shared
/// (TreeModel::identity). Thread-safe.
std::shared_ptr<const Archetype> sharedArchetype(const TreeForm& tree);

static_assert(Archetype::details[0].modes <= ModalDetail::maxModes &&
              Archetype::details[0].patches <= ModalDetail::maxPatches);

} // namespace osgTreeWind
