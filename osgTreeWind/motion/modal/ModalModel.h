// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/JointTree.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// Level of detail of a ModalModel.
struct ModalDetail {
    std::size_t modes = 12;   ///< Maximum number, 1 to maxModes.
    std::size_t patches = 10; ///< Maximum number, 1 to maxPatches.

    static constexpr std::size_t maxModes = 16, maxPatches = 32;
};

/// Exponents of growth quantities that do not follow a tree's scale: elastic modulus; branch wood over the
/// drawn wood; crown width over height; leaf mass over wood mass; and, relative to wood stiffness, the
/// stiffness of branches that hold themselves up, and of the roots.
struct SizePowers {
    float modulus = 0.0f, branches = 0.0f, width = 0.0f, leaves = 0.0f, support = 0.0f, roots = 0.0f;
};

/// Reduced model of a tree for the law `modal`: a few modes, and a few patches of the crown. Shared by
/// similar trees; immutable once made. The numbers apply to the tree it was made from; TreeFactors adapts
/// them to another one.
struct ModalModel {
    /// A mode. Its amplitude q turns joint i by phi_i q.
    struct Mode {
        float omega = 1.0f;       ///< Angular frequency without weight, rad/s.
        float weightShare = 0.0f; ///< Share of the stiffness that weight takes; clamped to [-1, 0.75].
        float limit = 1.0f;       ///< Bound of the amplitude, far beyond real ones; keeps numbers finite.
        float energyShare = 0.0f; ///< Share of the energy of all modes under gusts.
        /// Exponents of modal stiffness and mass, relative to a tree that is only scaled (TreeFactors).
        SizePowers stiffness, mass;
    };
    /// A part of the crown, exposed to one wind.
    struct Patch {
        glm::vec3 place{0.0f};  ///< Centre of drag, metres, the tree's frame.
        float woodDrag = 0.0f;  ///< Half the air density times CdA of wood, kg/m.
        float leafDrag = 0.0f;  ///< The same for leaves in wind, at 10 m/s.
        float stillDrag = 0.0f; ///< The same for leaves that move through still air.
        /// Exponents of drag above and below 10 m/s.
        float streamlining = 0.0f, breezeStreamlining = 0.0f;
    };

    std::size_t joints = 0;
    std::vector<std::size_t> patchOfLink; ///< Patch of each link.
    std::vector<Mode> modes;              ///< By energy under gusts, highest first.
    std::vector<Patch> patches;
    std::vector<float> levers; ///< V: per patch and axis x, y, z, its velocity per modal speed of each mode.
    std::vector<float> brakes; ///< Per patch and mode, modal damping per drag coefficient of the patch.
    /// [Phi R]: per joint, angle per modal amplitude and per patch force (x, y, z).
    std::vector<float> poses;
    std::vector<glm::vec2> leans; ///< Per mode, modalLeans(); in an Archetype.
    float height = 1.0f;          ///< Of the whole tree, metres; in an Archetype.
    float dampingRatio = 0.0f;    ///< Of wood.
    float streamlinedTo = 25.0f;  ///< m/s
    float maxAngle = 1.5f;        ///< Largest joint angle, radians.

    std::size_t columns() const { return modes.size() + 3 * patches.size(); }
};

/// Material properties of a tree for makeModalModels().
struct ModalMaterial {
    float dampingRatio = 0.05f;
    float streamlining = 0.0f, streamlinedTo = 25.0f; ///< Of leaves (WoodParameters).
    float maxAngle = 0.5f;
    float breezeStreamlining = 0.0f; ///< As the former two.
};

/// Builds a model per level of detail. Of the lowest modes it keeps those with most energy under gusts: at
/// least 8 if there are as many, and enough for 95 % of the energy.
/// @param details finest first; a coarser level keeps the first modes of a finer one.
std::vector<ModalModel> makeModalModels(const JointTree& tree, const ModalMaterial& material,
                                        const std::vector<ModalDetail>& details);

/// For each patch of `model`, the nearest patch of `other`; positions are divided by the lengths.
std::vector<std::size_t> nearestPatches(const ModalModel& model, float length, const ModalModel& other,
                                        float otherLength);

/// Modal stiffness of each mode of `model` on another tree with as many joints, over that on its own tree.
std::vector<double> stiffnessRatios(const ModalModel& model, const JointTree& other);
/// Modal mass likewise.
std::vector<double> massRatios(const ModalModel& model, const JointTree& other);

} // namespace osgTreeWind
