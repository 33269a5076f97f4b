// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/output/Json.h>

#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/io/TiledForest.h>

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
        std::cout << Json{{"trees", tiles.treeCount()}, {"columns", tiles.columns}, {"rows", tiles.rows()},
                          {"files", withTrees},         {"size", tiles.size},       {"range", tiles.range}}
                         .dump(2)
                  << '\n';
    else
        std::cout << "trees   " << tiles.treeCount() << "\ntiles   " << tiles.columns << " x " << tiles.rows()
                  << " of " << tiles.size << " m, " << withTrees << " with trees\nrange   " << tiles.range
                  << " m\n";
}

void cut(const TileOptions& options) {
    const auto forest = ForestStream::read(options.file, {options.output});
    if (!forest)
        throw Ending{forest.problems().front().file == options.output ? Failed : BadInput,
                     linesOf(forest.problems())};
    printNotes(options.file, forest.value().description().notes);
    if (forest.value().description().tiles)
        throw Ending{BadInput, options.file + ": its trees are in tiles already"};
    std::error_code ignored;
    if (std::filesystem::equivalent(options.file, options.output + "/world.treewind", ignored))
        throw Ending{BadInput,
                     "--output: " + options.output + " would lose " + options.file + ", which is read"};
    TilingOptions tiling;
    tiling.size = options.size;
    tiling.range = options.range;
    tiling.executor = ThreadPool::executor(static_cast<unsigned>(options.threads));
    print(valueOf(writeTiledForest(forest.value(), options.output, tiling), Failed), options.json);
}

/// Of input that is no good nothing is left, not even a folder.
void run(const TileOptions& options) {
    std::error_code ignored; // reading says so, where the folder is not there
    const bool isNew = std::filesystem::create_directories(options.output, ignored);
    try {
        cut(options);
    } catch (const Ending& ending) {
        if (ending.exitCode == BadInput && isNew)
            std::filesystem::remove(options.output, ignored);
        throw;
    }
}

} // namespace

void addTileCommand(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("tile", "Cut a forest into tiles that come and go with the camera");
    auto options = std::make_shared<TileOptions>();
    command->add_option("file", options->file, "A .treewind file")->required();
    command->add_option("-o,--output", options->output, "The folder of the world, made anew")->required();
    command
        ->add_option(
            "--size", options->size,
            "Side of a tile, metres; by default 1 km or so much less that a tile has some 2,000 trees")
        ->check(between(10, 100000));
    command
        ->add_option("--range", options->range,
                     "From how far trees are there, metres; by default as far as some 50,000 are, from 1 to "
                     "5 km")
        ->check(between(10, 100000));
    command->add_option("--parallel", options->threads, "Threads; by default one for each processor")
        ->check(between(1, 1024));
    command->add_flag("--json", options->json, "Print JSON");
    command->footer("The folder holds world.treewind, which osgviewer and all commands open, and tiles/;\n"
                    "docs/worlds.md says more.\n"
                    "Example: osgtreewind tile region.treewind -o world --size 500");
    command->callback([options] { run(*options); });
}
