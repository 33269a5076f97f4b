// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/output/Json.h>

#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/io/TiledForest.h>
#include <osgTreeWind/system/Path.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <system_error>

namespace {

using namespace osgTreeWind;

struct TileOptions {
    std::string file, output;
    double size = 0.0, range = 0.0;
    int threads = 0;
    bool json = false;
};

void print(const ForestTiles& tiles, bool json) {
    const auto withTrees = std::count_if(tiles.tiles.begin(), tiles.tiles.end(),
                                         [](const ForestTiles::Tile& tile) { return tile.trees > 0; });
    if (json)
        std::cout << textOf(Json{{"trees", tiles.treeCount()},
                                 {"columns", tiles.columns},
                                 {"rows", tiles.rows()},
                                 {"files", withTrees},
                                 {"size", tiles.size},
                                 {"range", tiles.range}})
                  << '\n';
    else
        std::cout << "trees   " << tiles.treeCount() << "\ntiles   " << tiles.columns << " x " << tiles.rows()
                  << " of " << tiles.size << " m, " << withTrees << " with trees\nrange   " << tiles.range
                  << " m\n";
}

void cut(const TileOptions& options) {
    const auto forest = ForestStream::read(options.file, {options.output});
    if (!forest)
        throwProblems(forest.problems(),
                      forest.problems().front().file == options.output ? Failed : BadInput);
    printNotes(options.file, forest.value().file().notes);
    if (forest.value().file().tiles)
        throw CommandError{BadInput, options.file + ": the forest is already in tiles"};
    std::error_code ignored;
    if (std::filesystem::equivalent(toPath(options.file), toPath(options.output + "/world.treewind"),
                                    ignored))
        throw CommandError{BadInput, "--output: a world in " + options.output + " would overwrite " +
                                         options.file + "; choose another folder"};
    TilingOptions tiling;
    tiling.size = options.size;
    tiling.range = options.range;
    tiling.executor = ThreadPool::executor(static_cast<unsigned>(options.threads));
    print(valueOrThrow(writeTiledForest(forest.value(), options.output, tiling), Failed), options.json);
}

/// Removes a new output folder if the input is bad.
void run(const TileOptions& options) {
    std::error_code ignored; // a missing folder is reported when reading
    const bool isNew = std::filesystem::create_directories(toPath(options.output), ignored);
    try {
        cut(options);
    } catch (const CommandError& error) {
        if (error.exitCode == BadInput && isNew)
            std::filesystem::remove(toPath(options.output), ignored);
        throw;
    }
}

} // namespace

void addTileCommand(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("tile", "Split a forest into tiles that are loaded around the camera");
    auto options = std::make_shared<TileOptions>();
    command->add_option("file", options->file, "Forest to split (.treewind file)")->required();
    command
        ->add_option("-o,--output", options->output,
                     "Folder for the world; a world that is there is replaced")
        ->required();
    command
        ->add_option("--size", options->size,
                     "Side of a tile, m (default: 1000, or less so that a tile has about 2,000 trees)")
        ->check(between(10, 100000));
    command
        ->add_option("--range", options->range,
                     "Distance from the camera within which trees are loaded, m (default: 1000 to 5000, for "
                     "about 50,000 trees)")
        ->check(between(10, 100000));
    command->add_option("--parallel", options->threads, "Number of threads (default: one for each processor)")
        ->check(between(1, 1024));
    command->add_flag("--json", options->json, "Print the result as JSON");
    command->footer(
        "The folder holds world.treewind, which osgviewer and the other commands open, and tiles/.\n"
        "See docs/worlds.md.\n"
        "Example: osgtreewind tile region.treewind -o world --size 500");
    command->callback([options] { run(*options); });
}
