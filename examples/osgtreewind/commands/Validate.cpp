// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/io/TiledForest.h>
#include <osgTreeWind/places/CrsTransform.h>
#include <osgTreeWind/wind/GridWind.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

namespace {

using namespace osgTreeWind;

void validateCatalogue(const std::string& file) {
    const SpeciesCatalogue catalogue = valueOrThrow(SpeciesCatalogue::read(file));
    std::cout << file << ": good, " << catalogue.species().size() << " species with the built-in ones\n";
}

/// The least and the greatest of several numbers.
class Extent {
public:
    void add(double number) {
        _low = std::min(_low, number);
        _high = std::max(_high, number);
    }
    bool isEmpty() const { return _low > _high; }
    double size() const { return _high - _low; }
    double middle() const { return 0.5 * (_low + _high); }
    std::string text() const {
        const std::string low = rounded(_low), high = rounded(_high);
        return low == high ? low : low + " to " + high;
    }
    static std::string rounded(double number) {
        std::ostringstream text;
        text.precision(std::abs(number) < 100.0 ? 2 : 12);
        text << (std::abs(number) < 100.0 ? number : std::round(number));
        return text.str();
    }

private:
    double _low = HUGE_VAL, _high = -HUGE_VAL;
};

/// Scene times of the data of a wind, at most about a hundred.
std::vector<double> timesOf(const Wind& wind) {
    std::vector<double> some;
    const auto addSome = [&](const std::vector<double>& all) {
        for (std::size_t i = 0; i < all.size(); i += 1 + all.size() / 100) {
            const double time = (all[i] - wind.clock.start) / wind.clock.scale;
            some.push_back(std::isfinite(time) ? time : 0.0);
        }
    };
    if (const auto* series = dynamic_cast<const TimeSeriesWind*>(wind.field.get()))
        addSome(series->series().times);
    else if (const auto* grid = dynamic_cast<const GridWind*>(wind.field.get()))
        addSome(grid->grid().times);
    if (some.empty())
        addSome({0.0});
    return some;
}

/// Speeds at a height above the feet of about a hundred trees, without gusts.
Extent windOf(const ForestFile& forest, float height) {
    Extent speeds;
    Wind steady = forest.wind;
    steady.gusts = {};
    const WindFieldPtr field = asField(steady);
    const std::vector<double> times = timesOf(steady);
    for (std::size_t i = 0; field && i < forest.trees.size(); i += 1 + forest.trees.size() / 100) {
        const glm::vec3 foot(forest.trees[i].position - forest.origin);
        for (const double time : times)
            speeds.add(glm::length(field->velocity({foot + glm::vec3(0, 0, height), foot.z}, time)));
    }
    return speeds;
}

/// " at 53.5500 N, 9.9812 E"; empty if the place is not on the map.
std::string placeText(const glm::dvec2& place, const std::string& crs) {
    const Result<Crs> map = Crs::parseMap(crs);
    const auto degrees = map ? longitudeLatitudeOf(place, map.value()) : std::nullopt;
    if (!degrees)
        return {};
    std::ostringstream text;
    text.precision(4);
    text << std::fixed << " at " << std::abs(degrees->y) << (degrees->y < 0.0 ? " S, " : " N, ")
         << std::abs(degrees->x) << (degrees->x < 0.0 ? " W" : " E");
    return text.str();
}

/// What stands where, so that a wrong place or unit meets the eye.
std::string summaryOf(const ForestFile& forest) {
    Extent east, north, heights, trunks;
    for (const TreePlacement& tree : forest.trees) {
        east.add(tree.position.x);
        north.add(tree.position.y);
        if (tree.size.height > 0.0f)
            heights.add(static_cast<double>(tree.size.height));
        if (tree.size.trunkDiameter > 0.0f)
            trunks.add(100.0 * static_cast<double>(tree.size.trunkDiameter));
    }
    std::string text;
    if (forest.trees.size() > 1)
        text = " on " + Extent::rounded(east.size()) + " m by " + Extent::rounded(north.size()) + " m";
    if (!forest.crs.empty() && !east.isEmpty())
        text += placeText({east.middle(), north.middle()}, forest.crs);
    if (!heights.isEmpty())
        text += ", " + heights.text() + " m high";
    if (!trunks.isEmpty())
        text += ", trunks of " + trunks.text() + " cm";
    const double height = forest.canopy.source == CanopySource::None ? 10.0 : forest.canopy.reference;
    const Extent wind = windOf(forest, static_cast<float>(height));
    return text + (wind.isEmpty() ? ", no wind"
                                  : ", wind of " + wind.text() + " m/s at " + Extent::rounded(height) + " m");
}

void validateForest(const std::string& file) {
    ForestFile forest = valueOrThrow(readForestFile(file));
    valueOrThrow(loadTiles(forest));
    for (const std::string& note : forest.notes)
        std::cout << file << ": note: " << note << '\n';
    std::cout << file << ": good, " << forest.trees.size() << (forest.trees.size() == 1 ? " tree" : " trees")
              << summaryOf(forest) << '\n';
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
