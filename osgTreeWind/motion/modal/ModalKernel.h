// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/ModalModel.h>

#include <cstddef>

namespace osgTreeWind {

/// One number for each of eight trees that are stepped together.
struct alignas(32) TreeLanes {
    static constexpr std::size_t count = 8;
    float tree[count] = {};
};

/// Factors that fit a model to one tree, in the order in which a block stores them.
///
/// Scaling all lengths by l and all radii by r changes stiffness by r^4 / l and mass by r^2 l^3. The modes'
/// SizePowers describe what deviates from that: the modulus follows slenderness, and leaves do not follow
/// wood.
struct TreeFactors {
    float cosine = 1.0f, sine = 0.0f;        ///< Of the heading.
    float length = 1.0f;                     ///< l
    float omegaSquare = 1.0f;                ///< r^2 / l^4: stiffness over mass.
    SizePowers logs;                         ///< Logarithms of growth quantities, over the model's tree.
    float leafDrag = 1.0f, stillDrag = 1.0f; ///< Relative to the model's; that of wood is r l.
    float contact = 0.0f;                    ///< Damping ratio added by contact with neighbouring crowns.
    float shelter = 1.0f;                    ///< NeighbourEffect::shelter
};

/// Floats per tree in a block: modal amplitudes, modal speeds, the wind at the patches (x, y, z, in the
/// tree's own axes), TreeFactors.
constexpr std::size_t treeFloats(std::size_t modes, std::size_t patches) {
    return 2 * modes + 3 * patches + sizeof(TreeFactors) / sizeof(float);
}
inline std::size_t treeFloats(const ModalModel& model) {
    return treeFloats(model.modes.size(), model.patches.size());
}

/// A step of eight trees of one model.
struct ModalStep {
    const ModalModel* model = nullptr;
    TreeLanes* block = nullptr; ///< treeFloats() elements.
    TreeLanes* wind = nullptr;  ///< At the patches at the end of the step: x, y, z, scene axes, m/s.
    float seconds = 0.0f;       ///< > 0; the wind changes linearly within the step.
    int substeps = 1;           ///< 0: sets the wind and does not move the trees.
    float gain = 1.0f;          ///< [0, 100]
};

/// Instruction sets the law is compiled for. Results are identical to the bit.
enum class InstructionSet { Baseline, Avx2, Avx512 };

/// The widest set of this machine, limited by the environment variable OSGTREEWIND_INSTRUCTIONS (baseline,
/// avx2, avx512).
InstructionSet bestInstructionSet();
const char* nameOf(InstructionSet set);

/// Steps the trees. @param set must be supported by the machine.
void stepTrees(const ModalStep& step, InstructionSet set);

} // namespace osgTreeWind
