// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/TreeRecord.h>

#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/output/CommandError.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <map>
#include <optional>
#include <vector>

using namespace osgTreeWind;

namespace {

/// The species of a forest, or of a catalogue (docs/species.md).
std::vector<Species> loadSpecies(const std::string& file) {
    if (!SpeciesCatalogue::isCatalogue(file))
        return loadForest(file).species;
    return valueOrThrow(SpeciesCatalogue::read(file)).species();
}

} // namespace

Species speciesByName(const std::string& name) {
    static std::map<std::string, Species> cache; // rows of a table often name the same species
    if (const auto known = cache.find(name); known != cache.end())
        return known->second;
    const std::size_t colon = name.rfind(".treewind:");
    if (colon == std::string::npos) {
        const std::optional<Species> species = findSpecies(name);
        if (!species)
            throw CommandError{BadInput,
                               "no built-in species \"" + name +
                                   "\"; osgtreewind sway --list prints their names, FILE.treewind:NAME takes "
                                   "a species from a file"};
        if (const std::string note = genericSpeciesNote(name, *species); !note.empty())
            printNotes(name, {note});
        return cache[name] = *species;
    }
    const std::string file = name.substr(0, colon + 9), own = name.substr(colon + 10);
    std::vector<std::string> names;
    for (const Species& species : loadSpecies(file)) {
        if (species.name == own)
            return cache[name] = species;
        names.push_back(species.name);
    }
    throw CommandError{BadInput, file + ": no species \"" + own + "\" in this file" +
                                     (names.empty() ? std::string() : "; expected one of " + joined(names))};
}

TreePlacement TreeRecord::makePlacement(const Species& kind) {
    TreePlacement tree;
    tree.size.height = static_cast<float>(height);
    tree.size.trunkDiameter = static_cast<float>(0.01 * diameter);
    tree.size.crownWidth = static_cast<float>(crownWidth);
    tree.openGrown = open;
    tree.leaves = static_cast<float>(leaves);
    if (diameter > 0.0 && height > 0.0 && crownWidth > 0.0)
        return tree;
    const TreeModel model = makeTreeModel(growthOf(kind, open));
    const TreeSize actual = measureTree(model, fitTree(model, completeSize(tree.size, kind, tree.openGrown)));
    if (diameter == 0.0)
        diameter = 100.0 * static_cast<double>(actual.trunkDiameter);
    if (height == 0.0)
        height = actual.height;
    if (crownWidth == 0.0)
        crownWidth = actual.crownWidth;
    return tree;
}

void addTreeOptions(CLI::App& command, TreeRecord& tree) {
    command
        .add_option("--species", tree.species,
                    "Built-in species, or FILE.treewind:NAME for a species of a file")
        ->capture_default_str();
    command.add_option("--dbh", tree.diameter, "Stem diameter at breast height (DBH), cm")
        ->check(between(0.1, 2000.0));
    command.add_option("--height", tree.height, "Height of the tree, m")->check(between(0.1, 150.0));
    command.add_option("--crown-width", tree.crownWidth, "Mean width of the crown, m")
        ->check(between(0.1, 150.0));
    command.add_flag("--open", tree.open,
                     "Tree grown alone in the open, with a wider crown than in a forest");
    command.add_option("--leaves", tree.leaves, "Share of the leaves on the tree, from 0 (bare) to 1 (all)")
        ->check(between(0.0, 1.0))
        ->capture_default_str();
}
