// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/io/TiledForest.h>

#include <algorithm>
#include <iostream>

namespace {

using namespace osgTreeWind;

void refuse(Diagnostics problems) {
    constexpr std::size_t maxPrinted = 100; // a world may lack a million tiles
    const std::size_t count = problems.size();
    problems.resize(std::min(count, maxPrinted));
    throw CommandError{BadInput, toString(problems) +
                                     (count > maxPrinted
                                          ? "\nand " + std::to_string(count - maxPrinted) + " more problems"
                                          : std::string())};
}

void validateCatalogue(const std::string& file) {
    const Result<SpeciesCatalogue> catalogue = SpeciesCatalogue::read(file);
    if (!catalogue)
        refuse(catalogue.problems());
    std::cout << file << ": good, " << catalogue.value().species().size()
              << " species with the built-in ones\n";
}

void validateForest(const std::string& file) {
    Result<ForestDescription> forest = readForestFile(file);
    const Diagnostics problems = forest ? loadTiles(forest.value()).problems() : forest.problems();
    if (!problems.empty())
        refuse(problems);
    for (const std::string& note : forest.value().notes)
        std::cout << file << ": note: " << note << '\n';
    std::cout << file << ": good, " << forest.value().trees.size() << " trees\n";
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
