// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/ModalModel.h>

#include <cstddef>

namespace osgTreeWind {

/// One number of each of eight trees that are stepped together.
struct alignas(32) TreeLanes {
    static constexpr std::size_t count = 8;
    float tree[count] = {};
};

/// A tree's own numbers beside its model's, in the order in which they stand in a block of trees.
///
/// All lengths times l and all radii times r change stiffness by r^4 / l and mass by r^2 l^3. Where a tree is
/// not so simple (its modulus follows its slenderness, its leaves do not follow its wood), the modes'
/// SizePowers say how.
struct TreeFactors {
    float cosine = 1.0f, sine = 0.0f;        ///< Of its heading.
    float length = 1.0f;                     ///< l
    float pace = 1.0f;                       ///< r^2 / l^4: stiffness over mass.
    SizePowers logs;                         ///< Logarithms of what else is not as on the model's tree.
    float leafDrag = 1.0f, stillDrag = 1.0f; ///< Over the model's; that of wood is r l.
    float contact = 0.0f;                    ///< Damping ratio that the crowns of neighbours add.
    float shelter = 1.0f;                    ///< TreeCompany::shelter
};

/// Floats a tree has in a block: amplitudes of the modes, their speeds, the wind at the patches (x, y, z, in
/// the tree's own axes), its factors.
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
    float seconds = 0.0f;       ///< > 0; the wind goes evenly from where it was to where it is.
    int substeps = 1;           ///< 0: the wind is taken for that of now, and nothing moves.
    float gain = 1.0f;          ///< [0, 100]
};

/// Instruction sets the law is compiled for. All give the same bits.
enum class InstructionSet { Baseline, Avx2, Avx512 };

/// The widest one this machine has; the environment's OSGTREEWIND_INSTRUCTIONS (baseline, avx2, avx512)
/// narrows it.
InstructionSet bestInstructionSet();
const char* nameOf(InstructionSet set);

/// Steps with that set; only one that the machine has.
void stepTrees(const ModalStep& step, InstructionSet set);

} // namespace osgTreeWind
