// SPDX-License-Identifier: MIT
#include "Command.h"

#include <osgTreeWind/motion/BuiltInSpecies.h>
#include <osgTreeWind/nodes/TreeLooks.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>
#include <memory>

namespace {

using namespace osgTreeWind;

struct PortraitOptions {
    std::string species;
    bool json = false;
};

/// A built-in species, or FILE.treewind:name. Nothing, said on standard error, where there is none.
std::optional<Species> findSpecies(const std::string& name) {
    const std::size_t colon = name.rfind(".treewind:");
    if (colon == std::string::npos) {
        if (std::optional<Species> species = findBuiltInSpecies(name))
            return species;
        std::cerr << "no built-in species \"" << name << "\"; osgtreewind sway --list names them\n";
        return {};
    }
    const std::string file = name.substr(0, colon + 9), own = name.substr(colon + 10);
    const auto forest = loadForest(file);
    if (!forest)
        return {};
    for (const Species& species : forest->species)
        if (species.name == own)
            return species;
    std::cerr << file << ": no species \"" << own << "\"\n";
    return {};
}

nlohmann::ordered_json toJson(const Species& species, const TreeLooks& looks) {
    const auto rounded = [](float value) { return std::round(1000.0 * static_cast<double>(value)) / 1000.0; };
    return {{"species", species.name},
            {"skyThroughCrown",
             {{"summer", rounded(looks.skyThroughCrownSummer)},
              {"winter", rounded(looks.skyThroughCrownWinter)}}},
            {"crownOverStem", rounded(looks.crownOverStem)},
            {"leafInclination", rounded(looks.leafInclination)},
            {"leafAreaDrawn", rounded(looks.leafAreaDrawn)},
            {"leafAreaMechanics", rounded(looks.leafAreaMechanics)},
            {"hueSpread", rounded(looks.hueSpread)},
            {"greenShare", rounded(looks.greenShare)}};
}

void print(const Species& species, const TreeLooks& looks) {
    const auto line = [](const char* name, float value) {
        std::printf("%-24s %8.3f\n", name, static_cast<double>(value));
    };
    std::printf("%s\n", species.name.c_str());
    line("skyThroughCrown, summer", looks.skyThroughCrownSummer);
    line("skyThroughCrown, winter", looks.skyThroughCrownWinter);
    line("crownOverStem", looks.crownOverStem);
    line("leafInclination, deg", looks.leafInclination);
    line("leafAreaDrawn, m2", looks.leafAreaDrawn);
    line("leafAreaMechanics, m2", looks.leafAreaMechanics);
    line("hueSpread, deg", looks.hueSpread);
    line("greenShare", looks.greenShare);
}

ExitCode portrait(const PortraitOptions& options) {
    const std::optional<Species> species = findSpecies(options.species);
    if (!species)
        return BadInput;
    const TreeLooks looks = measureLooks(*species);
    if (options.json)
        std::cout << toJson(*species, looks).dump(2) << '\n';
    else
        print(*species, looks);
    return Succeeded;
}

} // namespace

void addPortraitCommand(CLI::App& app, ExitCode& exitCode) {
    CLI::App* command = app.add_subcommand("portrait", "Measure the looks of a species");
    auto options = std::make_shared<PortraitOptions>();
    command->add_option("species", options->species, "A built-in species, or FILE.treewind:name")->required();
    command->add_flag("--json", options->json, "Print JSON");
    command->footer("Example: osgtreewind portrait oak --json");
    command->callback([options, &exitCode] { exitCode = portrait(*options); });
}
