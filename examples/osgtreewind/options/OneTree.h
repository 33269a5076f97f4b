// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <CLI/CLI.hpp>

#include <string>

/// A built-in species by its name, or FILE.treewind:name. The command ends if there is no such species.
osgTreeWind::Species speciesCalled(const std::string& name);

/// A tree as the words of a command ask for it.
struct OneTree {
    std::string species = "broadleaf";
    double diameter = 0.0, height = 0.0, crownWidth = 0.0; ///< cm and m; 0: not given.
    double leaves = 1.0;                                   ///< Share that it bears.
    bool open = false;

    /// Its placement. Fills in the sizes that were not given, as the tree has them.
    osgTreeWind::TreePlacement grown(const osgTreeWind::Species& kind);
};

/// Adds --species, --dbh, --height, --crown-width, --open and --leaves.
void addTreeOptions(CLI::App& command, OneTree& tree);
