// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/options/TreeRecord.h>
#include <examples/osgtreewind/options/TreeTable.h>
#include <examples/osgtreewind/output/Json.h>

#include <examples/osgtreewind/storm/SwayModes.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/sway/PullAndRelease.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <utility>
#include <vector>

namespace {

using namespace osgTreeWind;

struct SwayOptions : TreeRecord {
    double pull = 0.05;
    bool json = false;
    std::optional<float> season;
    std::string table;
};

void listSpecies() {
    for (const Species& species : SpeciesCatalogue::current().species()) {
        std::printf("%s", species.name.c_str());
        for (const std::string& alias : species.aliases)
            std::printf(", %s", alias.c_str());
        std::printf("\n  %s\n", species.source.c_str());
    }
}

/// The tree that the options ask for. Fills in the sizes that were not given.
TreePlacement treeOf(SwayOptions& options, const Species& species) {
    TreePlacement tree = options.makePlacement(species);
    if (options.season)
        tree.leaves *= leafShare(species.appearance, *options.season);
    return tree;
}

void printObject(const SwayOptions& options, const Species& species, const FreeSway& free,
                 const std::vector<SwayMode>& modes) {
    Json list = Json::array();
    for (const SwayMode& mode : modes)
        list.push_back({{"hz", mode.frequency}, {"damping", mode.dampingRatio}, {"share", mode.share}});
    std::cout << textOf(Json{{"species", species.name},
                             {"dbh_cm", options.diameter},
                             {"height_m", options.height},
                             {"crown_width_m", options.crownWidth},
                             {"open_grown", options.open},
                             {"leaves", options.leaves},
                             {"frequency_hz", free.frequency},
                             {"damping_ratio", free.dampingRatio},
                             {"modes", list}})
              << '\n';
}

void printLines(const SwayOptions& options, const Species& species, const FreeSway& free,
                const std::vector<SwayMode>& modes) {
    std::printf("%s, %.4g cm, %.4g m: frequency %.4f Hz, damping ratio %.3f\n\n", species.name.c_str(),
                options.diameter, options.height, free.frequency, free.dampingRatio);
    std::printf("modes      Hz  damping  share of gusts\n");
    for (std::size_t k = 0; k < modes.size(); ++k)
        std::printf("%5zu %7.3f  %7.3f  %14.3f\n", k + 1, modes[k].frequency, modes[k].dampingRatio,
                    modes[k].share);
}

void sway(SwayOptions options) {
    const Species species = speciesByName(options.species);
    const TreePlacement tree = treeOf(options, species);
    const std::optional<FreeSway> free = pullAndRelease(species, tree, options.pull);
    if (!free)
        throw CommandError{
            Failed,
            "the tree does not sway: it is damped critically, or three periods take more than ten minutes"};
    (options.json ? printObject : printLines)(options, species, *free, swayModes(species, tree));
}

/// Measures a tree for each row. The options fill in what the table leaves out.
void swayTable(const SwayOptions& defaults) {
    const TreeTable table = TreeTable::read(defaults.table);
    std::vector<std::pair<SwayOptions, Species>> trees; // all rows are checked before anything is printed
    for (const CsvTable::Row& row : table.rows()) {
        SwayOptions options = defaults;
        table.read(row, options);
        trees.emplace_back(options, table.species(row, options));
    }
    std::printf("species,dbh_cm,height_m,crown_width_m,open,leaves,frequency_hz,damping_ratio\n");
    for (auto& [options, species] : trees) {
        const TreePlacement tree = treeOf(options, species);
        const std::optional<FreeSway> free = pullAndRelease(species, tree, options.pull);
        std::printf("%s,%g,%g,%g,%d,%g,", species.name.c_str(), options.diameter, options.height,
                    options.crownWidth, options.open ? 1 : 0, options.leaves);
        if (free)
            std::printf("%.4f,%.4f\n", free->frequency, free->dampingRatio);
        else
            std::printf(",\n"); // the tree does not sway
    }
}

} // namespace

void addSwayCommand(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("sway", "Measure the natural frequency and the damping ratio of one tree");
    auto options = std::make_shared<SwayOptions>();
    addTreeOptions(*command, *options);
    addSeasonOption(*command, options->season);
    command
        ->add_option("--pull", options->pull,
                     "Displacement of the top of the trunk before release, as a share of its height")
        ->check(between(1e-4, 0.2))
        ->capture_default_str();
    command->add_flag("--json", options->json, "Print the result as JSON");
    command->add_option(
        "--table", options->table,
        "CSV file of trees to measure; prints a CSV table with frequencies and damping ratios");
    auto list = std::make_shared<bool>(false);
    command->add_flag("--list", *list, "List the built-in species and their sources");
    command->footer(
        "The tree is pulled at the top of its trunk and released in calm air; the frequency is that of the\n"
        "top. Sizes that are not given follow from the others and from the species. Method and validation:\n"
        "docs/validation.md.\n"
        "Columns of --table, all optional: species, dbh_cm, height_m, crown_width_m, open, leaves; the file\n"
        "of info --trees fits, too. Options fill in what the table leaves out.\n"
        "Example: osgtreewind sway --species oak --dbh 40 --height 18 --json");
    command->callback([options, list] {
        if (*list)
            listSpecies();
        else if (!options->table.empty())
            swayTable(*options);
        else
            sway(*options);
    });
}
