// SPDX-License-Identifier: MIT
#include "Command.h"

#include <iostream>

std::optional<osgTreeWind::ForestDescription> loadForest(const std::string& file) {
    osgTreeWind::Result<osgTreeWind::ForestDescription> forest = osgTreeWind::readForestFile(file);
    if (!forest) {
        std::cerr << forest.problems().front().text() << '\n';
        return {};
    }
    for (const std::string& note : forest.value().notes)
        std::cerr << file << ": note: " << note << '\n';
    return std::move(forest.value());
}

int main(int argc, char** argv) {
    CLI::App app{"Forests in a given wind field: look into, check, draw and simulate .treewind files."};
    app.name("osgtreewind");
    app.require_subcommand(1);
    app.footer("Examples:\n"
               "  osgtreewind info forest.treewind --json\n"
               "  osgtreewind render forest.treewind -o forest.png --size 1280x720 --start 3\n"
               "  osgtreewind render forest.treewind -o clip.mp4 --frames 150 --fps 30\n"
               "  osgtreewind simulate forest.treewind --duration 10 --fps 60 -o motion.csv\n"
               "Exit status: 0 done, 1 failed, 2 bad usage or bad input.");

    ExitCode exitCode = Succeeded;
    addInfoCommand(app, exitCode);
    addValidateCommand(app, exitCode);
    addRenderCommand(app, exitCode);
    addSimulateCommand(app, exitCode);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? Succeeded : BadInput;
    }
    return exitCode;
}
