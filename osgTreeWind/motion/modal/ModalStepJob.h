// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/motion/modal/ModalState.h>
#include <osgTreeWind/wind/WindField.h>

namespace osgTreeWind {

/// Moves trees under the law `modal` on in a wind, eight at a time. What comes out does not depend on threads
/// or on the instruction set.
struct ModalStepJob {
    ModalState* state = nullptr;     ///< Changed by run().
    const WindField* wind = nullptr; ///< Null: calm.
    double time = 0.0;               ///< To which it moves them, seconds; near trees.
    /// For which it moves them; the wind goes evenly to what it is at `time`. 0: that wind is taken as the
    /// one of now, and nothing moves.
    float seconds = 0.0f;
    /// Far trees step every farStep seconds, from whenever time began, in so many turns.
    std::size_t turns = 16;
    const Executor* executor = nullptr; ///< Null: in the calling thread.
    InstructionSet instructions = InstructionSet::Baseline;

    static constexpr float farStep = 0.2f; ///< Seconds.

    /// Whether there is a state, `turns` is above 0 and times are finite and run forward.
    bool validate() const;
    /// @return validate(); where it is false nothing is changed.
    bool run() const;

private:
    struct Scratch;
    void planWork() const;
    void advance(std::size_t first, std::size_t end, Scratch& scratch) const;
    void sampleWind(std::size_t first, std::size_t end, Scratch& scratch) const;
    WindPlace* addPlaces(const ModalState::Work& work, WindPlace* out) const;
};

} // namespace osgTreeWind
