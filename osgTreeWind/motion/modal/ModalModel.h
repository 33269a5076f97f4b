// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/JointTree.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// How finely a tree is taken.
struct ModalDetail {
    std::size_t modes = 12;   ///< The most, 1 to maxModes.
    std::size_t patches = 10; ///< The most, 1 to maxPatches.

    static constexpr std::size_t maxModes = 16, maxPatches = 32;
};

/// Powers of what does not follow a tree's scale: the modulus of its wood, how much wood its branches have
/// over what is drawn, the width of its crown over its height, the mass of its leaves over that of wood; and,
/// over how stiff its wood is, how stiff branches are to hold themselves up, and its roots.
struct SizePowers {
    float modulus = 0.0f, branches = 0.0f, width = 0.0f, leaves = 0.0f, support = 0.0f, roots = 0.0f;
};

/// What the law `modal` knows of a tree: a few modes and a few patches of its crown. Shared by all trees of
/// one form; immutable once made.
///
/// Numbers are those of the tree it was made from. A tree of other sizes has its own factors (TreeFactors).
struct ModalModel {
    /// A mode. Its amplitude q turns joint i by phi_i q.
    struct Mode {
        float pace = 1.0f;        ///< Circular frequency without weight, rad/s.
        float weightShare = 0.0f; ///< What weight takes of its stiffness; held within [-1, 0.75].
        float limit = 1.0f; ///< Of the amplitude: far beyond the largest angles, so that numbers stay finite.
        float energyShare = 0.0f; ///< Of the energy of all modes under gusts.
        /// Powers with which stiffness and mass differ from those of a tree scaled as it is (TreeFactors).
        SizePowers stiffness, mass;
    };
    /// A part of the crown on which one wind acts.
    struct Patch {
        glm::vec3 place{0.0f};  ///< Middle of its drag, metres, the tree's frame.
        float woodDrag = 0.0f;  ///< Half the air's density times CdA of wood, kg/m;
        float leafDrag = 0.0f;  ///< of leaves in wind,
        float stillDrag = 0.0f; ///< of leaves in still air.
        /// Exponents of its drag above and below 10 m/s.
        float streamlining = 0.0f, breezeStreamlining = 0.0f;
    };

    std::size_t joints = 0;
    std::vector<std::size_t> patchOfLink; ///< Per link, the patch it is part of.
    std::vector<Mode> modes;              ///< By energy under gusts, most first.
    std::vector<Patch> patches;
    std::vector<float> levers; ///< V: per patch 3 x modes, its velocity by speed of each mode: x, y, z.
    std::vector<float> brakes; ///< Per patch and mode, what its brake adds to the mode's own.
    std::vector<float>
        poses; ///< [Phi R]: per joint, by amplitude of each mode and then by patch force (x, y, z).
    std::vector<glm::vec2> leans; ///< Per mode, modalLeans(), and
    float height = 1.0f;          ///< of the whole tree, metres; of an Archetype's models.
    float dampingRatio = 0.0f;    ///< Of wood.
    float streamlinedTo = 25.0f;  ///< m/s
    float maxAngle = 1.5f;        ///< Of a joint, radians.

    std::size_t columns() const { return modes.size() + 3 * patches.size(); }
};

/// A tree's properties beside its joints.
struct ModalMaterial {
    float dampingRatio = 0.05f;
    float streamlining = 0.0f, streamlinedTo = 25.0f; ///< Of leaves (WoodParameters).
    float maxAngle = 0.5f;
    float breezeStreamlining = 0.0f; ///< As the former two.
};

/// Takes the modes with most energy under gusts out of the slowest ones: at least 8 (where there are as
/// many), and as many more as it takes for 95 % of the energy.
/// @param details finest first: the modes of a coarser one are the first of a finer one.
std::vector<ModalModel> makeModalModels(const JointTree& tree, const ModalMaterial& material,
                                        const std::vector<ModalDetail>& details);

/// Per patch of `model`, the nearest one of `other`, in lengths of either.
std::vector<std::size_t> nearestPatches(const ModalModel& model, float length, const ModalModel& other,
                                        float otherLength);

/// Stiffness of each mode of `model` on another tree of as many joints, over that on its own.
std::vector<double> stiffnessRatios(const ModalModel& model, const JointTree& other);
/// Mass of each, likewise.
std::vector<double> massRatios(const ModalModel& model, const JointTree& other);

} // namespace osgTreeWind
