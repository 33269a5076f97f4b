// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>

#include <osgTreeWind/io/TiledForest.h>

#include <algorithm>
#include <iostream>

void addValidateCommand(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("validate", "Check a file and list its problems with line and column");
    auto file = std::make_shared<std::string>();
    command->add_option("file", *file, "Forest or world to check (.treewind file)")->required();
    command->footer("Example: osgtreewind validate forest.treewind");
    command->callback([file] {
        auto forest = osgTreeWind::readForestFile(*file);
        osgTreeWind::Diagnostics problems = forest.problems();
        if (forest)
            problems = loadTiles(forest.value()).problems();
        if (problems.empty()) {
            for (const std::string& note : forest.value().notes)
                std::cout << *file << ": note: " << note << '\n';
            std::cout << *file << ": good, " << forest.value().trees.size() << " trees\n";
            return;
        }
        constexpr std::size_t maxPrinted = 100; // a world may lack a million tiles
        const std::size_t count = problems.size();
        problems.resize(std::min(count, maxPrinted));
        throw CommandError{BadInput, toString(problems) +
                                         (count > maxPrinted ? "\nand " + std::to_string(count - maxPrinted) +
                                                                   " more problems"
                                                             : std::string())};
    });
}
