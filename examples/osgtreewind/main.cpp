// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/output/Signals.h>

#include <osgTreeWind/base/AtomicFile.h>
#include <osgTreeWind/base/BadAccess.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Unicode.h>
#include <osgTreeWind/motion/MakeCanopyMap.h>
#include <osgTreeWind/motion/MemoryEstimate.h>
#include <osgTreeWind/system/Console.h>
#include <osgTreeWind/system/Program.h>

#include <algorithm>
#include <cctype>
#include <iomanip>
#include <iostream>
#include <sstream>

CLI::Validator between(double low, double high) {
    const std::string range = "from " + osgTreeWind::numberText(low) + " to " + osgTreeWind::numberText(high);
    const auto problem = [low, high, range](const std::string& text) {
        const std::optional<double> number = osgTreeWind::parseNumber(text);
        return number && *number >= low && *number <= high
                   ? std::string()
                   : osgTreeWind::expectedFound("a number " + range, text);
    };
    return CLI::Validator(problem, range, "within");
}

void addSeasonOption(CLI::App& command, std::optional<float>& season) {
    const auto read = [&season](const std::string& text) {
        season = osgTreeWind::parseSeason(text);
        if (!season)
            throw CLI::ValidationError("--season",
                                       osgTreeWind::expectedFound(osgTreeWind::seasonSyntax, text));
    };
    command.add_option_function<std::string>("--season", read,
                                             "Season: winter, spring, summer, autumn, a number from 0 "
                                             "(midwinter) to 4, or a date such as 2024-11-05");
}

void addTilesOption(CLI::App& command, osgTreeWind::TileBox& tiles) {
    const auto read = [&tiles](const std::vector<std::uint32_t>& ends) {
        tiles = {ends[0], ends[1], ends[ends.size() - 2], ends[ends.size() - 1]};
        if (ends.size() == 3 || tiles.firstColumn > tiles.lastColumn || tiles.firstRow > tiles.lastRow)
            throw CLI::ValidationError(
                "--tiles", "expected COLUMN,ROW or COLUMN,ROW,COLUMN,ROW, the lower column and row first");
    };
    command
        .add_option_function<std::vector<std::uint32_t>>(
            "--tiles", read,
            "Tiles of a world to read: COLUMN,ROW, or COLUMN,ROW,COLUMN,ROW for a rectangle (default: all)")
        ->delimiter(',')
        ->expected(2, 4)
        ->allow_extra_args(false);
}

namespace {

/// The help of CLI11 2.1, also from later versions: these write headings in capitals, leave out "Usage:",
/// join the lines of examples, and break those of commands.
class HelpFormatter : public CLI::Formatter {
public:
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
        const auto stripped = [](const std::string& text) {
            const std::size_t begin = text.find_first_not_of('\n');
            return begin == std::string::npos ? ""
                                              : text.substr(begin, text.find_last_not_of('\n') + 1 - begin);
        };
        std::string usage = stripped(make_usage(app, std::move(name)));
        if (usage.rfind("Usage: ", 0) != 0)
            usage.insert(0, "Usage: ");
        std::string lists = make_positionals(app) + make_groups(app, mode) + make_subcommands(app, mode);
        for (const std::string heading : {"Positionals", "Options", "Subcommands"}) {
            std::string capitals = heading;
            std::transform(heading.begin(), heading.end(), capitals.begin(), ::toupper);
            lists = CLI::detail::find_and_replace(lists, '\n' + capitals + ":\n", '\n' + heading + ":\n");
        }
        return stripped(make_description(app)) + '\n' + usage + '\n' + lists + '\n' +
               stripped(make_footer(app)) + '\n';
    }
    std::string make_subcommand(const CLI::App* command) const override {
        std::ostringstream line;
        line << std::left << std::setw(static_cast<int>(column_width_)) << "  " + command->get_name()
             << command->get_description() << '\n';
        return line.str();
    }
};

/// Shelter distance in a world that does not give the reach of its stands, metres.
constexpr double defaultShelterReach = 200.0;

ForestPart load(const std::string& file, const osgTreeWind::TileBox& tiles, bool withNeighbours) {
    osgTreeWind::ForestFile forest = valueOrThrow(osgTreeWind::readForestFile(file));
    const double shelter = forest.canopy.reach > 0.0 ? shelterReach(forest.canopy) : defaultShelterReach;
    const auto requested = valueOrThrow(loadTiles(forest, tiles, withNeighbours ? shelter : 0.0));
    printNotes(file, forest.notes);
    return {std::move(forest), requested};
}

} // namespace

void printNotes(const std::string& file, const std::vector<std::string>& notes) {
    for (const std::string& note : notes)
        std::cerr << asUtf8(file + ": note: " + note) << '\n';
}

void checkOutputPath(const std::string& output) {
    if (osgTreeWind::AtomicFile(output).isSpecial())
        throw CommandError{BadInput,
                           "--output: " + output + " exists and is not a regular file; choose another name"};
}

ForestPart loadPart(const std::string& file, const osgTreeWind::TileBox& tiles) {
    return load(file, tiles, true);
}

osgTreeWind::ForestFile loadForest(const std::string& file, const osgTreeWind::TileBox& tiles,
                                   bool withNodes) {
    ForestPart part = load(file, tiles, false);
    const std::string problem = withNodes ? osgTreeWind::problemOfMemory(part.forest, true) : std::string();
    if (!problem.empty())
        throw CommandError{BadInput, file + ": " + problem};
    return std::move(part.forest);
}

int main(int argc, char** argv) {
    osgTreeWind::trustOwnLibraries();
    osgTreeWind::stopAtBadAccess();
    exitOnSignals();
    osgTreeWind::useUtf8Console();
    CLI::App app{"Inspect, check, draw and simulate forests in a wind field (.treewind files)."};
    app.name("osgtreewind");
    app.allow_windows_style_options(false); // a path may begin with /
    app.formatter(std::make_shared<HelpFormatter>());
    app.set_version_flag("--version", "osgtreewind " OSGTREEWIND_VERSION);
    app.require_subcommand(1);

    addInfoCommand(app);
    addValidateCommand(app);
    addRenderCommand(app);
    addSimulateCommand(app);
    addSwayCommand(app);
    addStormCommand(app);
    addRiskCommand(app);
    addPortraitCommand(app);
    addBenchCommand(app);
    addWindCommand(app);
    addCanopyCommand(app);
    addTileCommand(app);
    addMergeCommand(app);
    addViewCommand(app);
    app.footer("Examples:\n"
               "  osgtreewind info forest.treewind --json\n"
               "  osgtreewind render forest.treewind -o forest.png --size 1280x720 --start 3\n"
               "  osgtreewind render forest.treewind -o clip.mp4 --frames 150 --fps 30\n"
               "  osgtreewind simulate forest.treewind --duration 10 --fps 60 -o motion.csv\n"
               "  osgtreewind wind wind.vtk --at 120,40,10\n"
               "  osgtreewind canopy forest.treewind -o canopy.nc --cell 2\n"
               "  osgtreewind risk forest.treewind -o risk.gpkg --speed 20 --direction 225\n"
               "  osgtreewind tile region.treewind -o world\n"
               "  osgtreewind bench -o results.json\n"
               "Exit status: 0 success, 1 failure, 2 wrong usage or bad input,\n"
               "130 ended by SIGINT, 143 ended by SIGTERM.");
    try {
        std::vector<std::string> arguments = osgTreeWind::programArguments(argc, argv);
        arguments.erase(arguments.begin());
        std::reverse(arguments.begin(), arguments.end()); // as CLI11 wants them
        app.parse(std::move(arguments));
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? Succeeded : BadInput;
    } catch (const CommandError& error) {
        std::cerr << error.message << '\n';
        return error.exitCode;
    } catch (const std::exception& error) { // for example, not enough memory for a picture
        std::cerr << "osgtreewind: " << error.what() << '\n';
        return Failed;
    }
    if (!std::cout.flush()) {
        std::cerr << "standard output: cannot be written\n";
        return Failed;
    }
    return Succeeded;
}
