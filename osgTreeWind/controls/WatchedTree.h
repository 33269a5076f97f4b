// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/TreeId.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/damage/HeldJoint.h>
#include <osgTreeWind/motion/damage/TreeStrength.h>

#include <optional>
#include <string>

namespace osgTreeWind {

/// A tree that somebody wants to know more of: what it is, and how it sways now.
class WatchedTree {
public:
    WatchedTree(const ForestSimulation& simulation, TreeId tree);

    TreeId id() const { return _tree; }
    /// Two lines: what it is; its frequency, its lean, and its moment at the foot against what it bears.
    /// Empty where it is gone.
    std::string text(const ForestSimulation& simulation) const;

private:
    std::string swayText(const ForestSimulation& simulation) const;

    TreeId _tree;
    std::string _what;
    double _frequency = 0.0; ///< Hz, and the following two under `modal` alone.
    std::optional<HeldJoint> _foot;
    TreeStrength _strength;
};

} // namespace osgTreeWind
