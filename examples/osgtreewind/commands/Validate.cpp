// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/io/TiledForest.h>

#include <iostream>

namespace {

using namespace osgTreeWind;

void validateCatalogue(const std::string& file) {
    const SpeciesCatalogue catalogue = valueOrThrow(SpeciesCatalogue::read(file));
    std::cout << file << ": good, " << catalogue.species().size() << " species with the built-in ones\n";
}

void validateForest(const std::string& file) {
    ForestFile forest = valueOrThrow(readForestFile(file));
    valueOrThrow(loadTiles(forest));
    for (const std::string& note : forest.notes)
        std::cout << file << ": note: " << note << '\n';
    std::cout << file << ": good, " << forest.trees.size() << " trees\n";
}

} // namespace

void addValidateCommand(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("validate", "Check a file and list its problems with line and column");
    auto file = std::make_shared<std::string>();
    command->add_option("file", *file, "Forest, world or species.treewind to check")->required();
    command->footer("Example: osgtreewind validate forest.treewind");
    command->callback(
        [file] { SpeciesCatalogue::isCatalogue(*file) ? validateCatalogue(*file) : validateForest(*file); });
}
