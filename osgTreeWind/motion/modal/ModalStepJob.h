// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/motion/modal/ModalState.h>
#include <osgTreeWind/wind/WindField.h>

namespace osgTreeWind {

/// Steps trees under the law `modal`, eight at a time. Results do not depend on threads or instructions.
struct ModalStepJob {
    ModalState* state = nullptr;     ///< Changed by run().
    const WindField* wind = nullptr; ///< Null: calm.
    double time = 0.0;               ///< End of the step, seconds; near trees.
    /// Duration; the wind changes linearly to that at `time`. 0: sets the wind and does not move the trees.
    float seconds = 0.0f;
    /// Far trees step every farStep seconds, in this many staggered groups.
    std::size_t turns = 16;
    const Executor* executor = nullptr; ///< Null: in the calling thread.
    InstructionSet instructions = InstructionSet::Baseline;

    static constexpr float farStep = 0.2f; ///< Seconds.

    /// Whether there is a state, `turns` is above 0, and `time` and `seconds` >= 0 are finite.
    bool validate() const;
    /// @return validate(); if it is false, nothing is changed.
    bool run() const;

private:
    struct Scratch;
    void planWork() const;
    void advance(std::size_t first, std::size_t end, Scratch& scratch) const;
    void sampleWind(std::size_t first, std::size_t end, Scratch& scratch) const;
    WindPlace* addPlaces(const ModalState::Work& work, WindPlace* out) const;
};

} // namespace osgTreeWind
