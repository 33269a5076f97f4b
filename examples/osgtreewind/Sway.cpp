// SPDX-License-Identifier: MIT
#include "Command.h"

#include <osgTreeWind/motion/BuiltInSpecies.h>
#include <osgTreeWind/motion/GrowthLaws.h>
#include <osgTreeWind/motion/PullAndRelease.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>
#include <memory>

namespace {

using namespace osgTreeWind;

struct SwayOptions {
    std::string species = "broadleaf";
    double diameter = 0.0, height = 0.0, crownWidth = 0.0, leaves = 1.0;
    bool open = false;
    bool json = false;
};

void listSpecies() {
    for (const BuiltInSpecies& built : builtInSpecies()) {
        for (std::size_t i = 0; i < built.names.size(); ++i)
            std::printf("%s%s", i == 0 ? "" : ", ", built.names[i].c_str());
        std::printf("\n  %s\n", built.source.c_str());
    }
}

/// Sizes that were not given, as the tree has them.
void fillIn(SwayOptions& options, const Species& species, const TreePlacement& tree) {
    if (options.diameter > 0.0 && options.height > 0.0 && options.crownWidth > 0.0)
        return;
    const TreeModel model = makeTreeModel(species.tree, 0);
    const TreeSize actual =
        measureTree(model, fitTree(model, withCrown(tree.size, species.crown, tree.openGrown)));
    if (options.diameter == 0.0)
        options.diameter = 100.0 * static_cast<double>(actual.trunkDiameter);
    if (options.height == 0.0)
        options.height = actual.height;
    if (options.crownWidth == 0.0)
        options.crownWidth = actual.crownWidth;
}

ExitCode sway(SwayOptions options) {
    std::optional<Species> species = findBuiltInSpecies(options.species);
    if (!species) {
        species = defaultSpecies();
        std::cerr << "note: no built-in species \"" << options.species << "\"; \"" << species->name
                  << "\" stands for it\n";
    }
    TreePlacement tree;
    tree.size.height = static_cast<float>(options.height);
    tree.size.trunkDiameter = static_cast<float>(0.01 * options.diameter);
    tree.size.crownWidth = static_cast<float>(options.crownWidth);
    tree.openGrown = options.open;
    tree.leaves = static_cast<float>(options.leaves);
    fillIn(options, *species, tree);
    const std::optional<FreeSway> free = pullAndRelease(*species, tree);
    if (!free) {
        std::cerr << "the tree does not swing: three periods take more than ten minutes\n";
        return Failed;
    }
    if (options.json)
        std::cout << nlohmann::ordered_json{{"species", species->name},
                                            {"dbh_cm", options.diameter},
                                            {"height_m", options.height},
                                            {"crown_width_m", options.crownWidth},
                                            {"open_grown", options.open},
                                            {"leaves", options.leaves},
                                            {"frequency_hz", free->frequency},
                                            {"damping_ratio", free->dampingRatio}}
                         .dump(2)
                  << '\n';
    else
        std::printf("%s, %.4g cm, %.4g m: frequency %.4f Hz, damping ratio %.3f\n", species->name.c_str(),
                    options.diameter, options.height, free->frequency, free->dampingRatio);
    return Succeeded;
}

} // namespace

void addSwayCommand(CLI::App& app, ExitCode& exitCode) {
    CLI::App* command =
        app.add_subcommand("sway", "Pull one tree, let go in a calm and measure how it sways");
    auto options = std::make_shared<SwayOptions>();
    command->add_option("--species", options->species, "Common or scientific name of a built-in species")
        ->capture_default_str();
    command->add_option("--dbh", options->diameter, "Diameter of the trunk at breast height, cm")
        ->check(within(0.1, 2000.0));
    command->add_option("--height", options->height, "Height of the tree, m")->check(within(0.1, 150.0));
    command->add_option("--crown-width", options->crownWidth, "Mean width of the crown, m")
        ->check(within(0.1, 150.0));
    command->add_flag("--open", options->open, "It stands by itself: its crown is wider than in a forest");
    command->add_option("--leaves", options->leaves, "Share of its leaves that it bears, 0 to 1")
        ->check(within(0.0, 1.0))
        ->capture_default_str();
    command->add_flag("--json", options->json, "Print an object instead of a line");
    auto list = std::make_shared<bool>(false);
    command->add_flag("--list", *list, "List the built-in species and their sources");
    command->footer(
        "The frequency is that of the top of the trunk; method and validation: docs/validation.md.\n"
        "A crown that is not given follows the diameter, another size the shape of the species.\n"
        "Example: osgtreewind sway --species oak --dbh 40 --height 18 --json");
    command->callback([options, list, &exitCode] {
        if (*list)
            listSpecies();
        else
            exitCode = sway(*options);
    });
}
