// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/TreeId.h>
#include <osgTreeWind/motion/ForestSimulation.h>

#include <string>

namespace osgTreeWind {

/// The description of a selected tree: its size, and its sway now.
class SelectedTree {
public:
    SelectedTree(const ForestSimulation& simulation, TreeId tree);

    TreeId id() const { return _tree; }
    /// Two lines: name, species and size; natural frequency, lean, and moment at the foot with its limit.
    /// Empty if the tree was removed.
    std::string text(const ForestSimulation& simulation) const;

private:
    TreeId _tree;
    std::string _description;
};

} // namespace osgTreeWind
