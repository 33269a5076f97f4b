// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/OneTree.h>

#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/output/Ending.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <map>
#include <optional>

using namespace osgTreeWind;

Species speciesCalled(const std::string& name) {
    const std::size_t colon = name.rfind(".treewind:");
    if (colon == std::string::npos) {
        if (const std::optional<Species> species = findSpecies(name))
            return *species;
        throw Ending{BadInput,
                     "no built-in species \"" + name +
                         "\"; osgtreewind sway --list names them, FILE.treewind:name takes one of a file"};
    }
    static std::map<std::string, Species> read; // rows of a table name one file again and again
    if (const auto known = read.find(name); known != read.end())
        return known->second;
    const std::string file = name.substr(0, colon + 9), own = name.substr(colon + 10);
    const ForestDescription forest = loadForest(file);
    for (const Species& species : forest.species)
        if (species.name == own)
            return read[name] = species;
    throw Ending{BadInput, file + ": no species \"" + own + "\""};
}

TreePlacement OneTree::grown(const Species& kind) {
    TreePlacement tree;
    tree.size.height = static_cast<float>(height);
    tree.size.trunkDiameter = static_cast<float>(0.01 * diameter);
    tree.size.crownWidth = static_cast<float>(crownWidth);
    tree.openGrown = open;
    tree.leaves = static_cast<float>(leaves);
    if (diameter > 0.0 && height > 0.0 && crownWidth > 0.0)
        return tree;
    const TreeModel model = makeTreeModel(growthOf(kind, open));
    const TreeSize actual = measureTree(model, fitTree(model, wholeSize(tree.size, kind, tree.openGrown)));
    if (diameter == 0.0)
        diameter = 100.0 * static_cast<double>(actual.trunkDiameter);
    if (height == 0.0)
        height = actual.height;
    if (crownWidth == 0.0)
        crownWidth = actual.crownWidth;
    return tree;
}

void addTreeOptions(CLI::App& command, OneTree& tree) {
    command.add_option("--species", tree.species, "A built-in species by its name, or FILE.treewind:name")
        ->capture_default_str();
    command.add_option("--dbh", tree.diameter, "Diameter of the trunk at breast height, cm")
        ->check(between(0.1, 2000.0));
    command.add_option("--height", tree.height, "Height of the tree, m")->check(between(0.1, 150.0));
    command.add_option("--crown-width", tree.crownWidth, "Mean width of the crown, m")
        ->check(between(0.1, 150.0));
    command.add_flag("--open", tree.open, "It stands by itself: its crown is wider than in a forest");
    command.add_option("--leaves", tree.leaves, "Share of its leaves that it bears, 0 to 1")
        ->check(between(0.0, 1.0))
        ->capture_default_str();
}
