// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/options/Offscreen.h>
#include <examples/osgtreewind/options/TreeRecord.h>
#include <examples/osgtreewind/output/Json.h>
#include <examples/osgtreewind/pictures/WritePicture.h>
#include <examples/osgtreewind/portraits/PortraitSheet.h>

#include <examples/osgtreewind/portraits/TreeLooks.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <osgDB/FileNameUtils>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

namespace {

using namespace osgTreeWind;

struct PortraitOptions {
    std::string species, output, backend = offscreenBackendName();
    bool json = false, forest = false;
    int panel = 256;
    std::optional<float> season;
};

const char* growingPlaceOf(const PortraitOptions& options) {
    return options.forest ? "a forest" : "the open";
}

Json toJson(const Species& species, const TreeLooks& looks) {
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

void print(const Species& species, const char* growingPlace, const TreeLooks& looks) {
    const auto line = [](const char* name, float value) {
        std::printf("%-24s %8.3f\n", name, static_cast<double>(value));
    };
    std::printf("%s\ngrown in %s\n", species.name.c_str(), growingPlace);
    line("skyThroughCrown, summer", looks.skyThroughCrownSummer);
    line("skyThroughCrown, winter", looks.skyThroughCrownWinter);
    line("crownOverStem", looks.crownOverStem);
    line("leafInclination, deg", looks.leafInclination);
    line("leafAreaDrawn, m2", looks.leafAreaDrawn);
    line("leafAreaMechanics, m2", looks.leafAreaMechanics);
    line("hueSpread, deg", looks.hueSpread);
    line("greenShare", looks.greenShare);
}

/// Writes a forest of one tree with all keys of its species.
void writeSpecies(const Species& species, const std::string& path) {
    ForestDescription forest;
    forest.species = {species};
    forest.trees.emplace_back();
    throwIfAny(writeForestFile(forest, path), Failed);
}

void portrait(const PortraitOptions& options) {
    Species species = speciesByName(options.species);
    if (osgDB::getLowerCaseFileExtension(options.output) == "treewind")
        return writeSpecies(species, options.output);
    species.tree = growthOf(species, !options.forest);
    if (!options.output.empty() && options.backend != offscreenBackendName())
        runOtherBackend(options.backend);
    if (!options.output.empty()) {
        const osg::ref_ptr<osg::Image> sheet =
            drawPortrait(species, !options.forest, options.panel, options.season.value_or(midspring));
        writePicture(*sheet, options.output);
    }
    const TreeLooks looks = measureLooks(species);
    if (!options.json)
        return print(species, growingPlaceOf(options), looks);
    Json json = toJson(species, looks);
    json["grown"] = growingPlaceOf(options);
    std::cout << textOf(json) << '\n';
}

} // namespace

void addPortraitCommand(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("portrait", "Draw a sheet of pictures of a species and measure its appearance");
    auto options = std::make_shared<PortraitOptions>();
    command
        ->add_option("species", options->species,
                     "Built-in species, or FILE.treewind:NAME for a species of a file")
        ->required();
    command->add_flag("--forest", options->forest,
                      "Show the species as it grows in a forest (default: as it grows in the open)");
    command->add_flag("--json", options->json, "Print the result as JSON");
    command
        ->add_option("-o,--output", options->output,
                     "PNG file for the sheet, or .treewind file for all keys of the species (default: none)")
        ->check([](const std::string& name) {
            const std::string extension = osgDB::getLowerCaseFileExtension(name);
            return extension == "png" || extension == "treewind"
                       ? std::string()
                       : expectedFound("a name that ends in .png or .treewind", name);
        });
    command->add_option("--panel", options->panel, "Width and height of each picture on the sheet, pixels")
        ->check(CLI::Range(16, 2048))
        ->capture_default_str();
    addSeasonOption(*command, options->season);
    addBackendOption(*command, options->backend);
    command->footer(
        std::string(portraitLayout) +
        "\nThe numbers are means over three shapes; docs/species.md compares them with measurements.\n"
        "Example: osgtreewind portrait oak -o oak.png --json");
    command->callback([options] { portrait(*options); });
}
