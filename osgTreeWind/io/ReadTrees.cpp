// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/NameMatching.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/forest/ForestKeys.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/ReadKeys.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <unordered_map>

namespace osgTreeWind {

namespace {

/// Uniform in [low, high].
double uniform(Random& random, double low, double high) {
    return low + (high - low) * random.uniformDouble();
}

std::optional<std::size_t> findSpecies(TableReader& table, DocumentSpecies& species,
                                       const std::string& name) {
    const auto found = species.findOrAdd(name);
    if (!found) {
        std::vector<std::string> known;
        for (const Species& each : species.all())
            known.push_back(each.name);
        const std::string declared = joined(known);
        for (const Species& built : species.builtIn().species()) {
            known.push_back(built.name);
            known.insert(known.end(), built.aliases.begin(), built.aliases.end());
        }
        const std::string similar = nearestName(name, known);
        table.problem("species", "no species " + inQuotes(name) + "; " +
                                     (similar.empty() ? "known: " + declared +
                                                            " and the built-in ones (osgtreewind sway --list)"
                                                      : "did you mean " + similar + '?'));
    }
    return found;
}

/// A number, or a range [min, max] from which a random number is drawn for each tree.
struct DrawnNumber {
    double min = 0.0, max = 0.0;
    double draw(Random& random) const { return uniform(random, min, max); }
};

std::optional<DrawnNumber> readDrawnNumber(TableReader& table, const std::string& key, const Range& range) {
    if (!table.hasArray(key)) {
        DrawnNumber number;
        if (!table.read(key, number.min, range))
            return std::nullopt;
        number.max = number.min;
        return number;
    }
    std::vector<double> ends;
    if (!table.readNumbers(key, ends, 2, 2, range))
        return std::nullopt;
    if (ends[0] > ends[1]) {
        table.problem(key, "expected [min, max] with min not above max");
        return std::nullopt;
    }
    return DrawnNumber{ends[0], ends[1]};
}

/// Points with a minimum distance, for dart throwing, in a hash of square cells.
class SpacedPoints {
public:
    explicit SpacedPoints(double spacing) : _spacing(spacing) {}

    /// Adds the point unless it is too close to another.
    bool add(const glm::dvec2& point) {
        if (_spacing == 0.0)
            return true;
        const std::int64_t x = cell(point.x), y = cell(point.y);
        for (std::int64_t i = x - 1; i <= x + 1; ++i)
            for (std::int64_t j = y - 1; j <= y + 1; ++j) {
                const auto [first, last] = _points.equal_range(key(i, j));
                for (auto other = first; other != last; ++other)
                    if (glm::distance(other->second, point) < _spacing)
                        return false;
            }
        _points.emplace(key(x, y), point);
        return true;
    }

private:
    std::int64_t cell(double x) const { return static_cast<std::int64_t>(std::floor(x / _spacing)); }
    static std::uint64_t key(std::int64_t x, std::int64_t y) {
        return Random(static_cast<std::uint64_t>(x)).next() ^ static_cast<std::uint64_t>(y);
    }

    double _spacing;
    std::unordered_multimap<std::uint64_t, glm::dvec2> _points;
};

struct Scatter {
    int count = 0;
    glm::dvec2 low{0.0}, high{0.0};
    double spacing = 0.0;
    std::vector<std::size_t> species;
    std::vector<double> weights;
    std::optional<DrawnNumber> height, trunkDiameter, crownWidth, trunkRatio, crownRatio;
    bool openGrown = false, isOpenGrownGiven = false;
    float leaves = 1.0f;
    std::uint32_t seed = 0;

    /// About the number of trees that fit into the area: random sequential addition of circles saturates at
    /// about 0.547 of it.
    double saturation() const {
        const double width = high.x - low.x + spacing, depth = high.y - low.y + spacing,
                     circle = glm::quarter_pi<double>() * spacing * spacing;
        return 0.547 * width * depth / circle;
    }

    /// A place for the next tree; empty if none is found.
    std::optional<glm::dvec2> drawPlace(SpacedPoints& others, Random& random) const {
        constexpr int maxTries = 2000;
        for (int tries = 0; tries < maxTries; ++tries) {
            const double x = uniform(random, low.x, high.x), y = uniform(random, low.y, high.y);
            if (others.add({x, y}))
                return glm::dvec2(x, y);
        }
        return std::nullopt;
    }

    TreePlacement drawTree(const glm::dvec2& place, Random& random) const {
        TreePlacement tree;
        tree.position = {place, 0.0};
        tree.species = drawSpecies(random);
        tree.size = drawSize(random);
        tree.openGrown = openGrown;
        tree.leaves = leaves;
        tree.heading = random.uniform() * glm::two_pi<float>();
        tree.seed = static_cast<std::uint32_t>(random.next());
        return tree;
    }

private:
    std::size_t drawSpecies(Random& random) const {
        double total = 0.0;
        for (double weight : weights)
            total += weight;
        double rest = uniform(random, 0.0, total);
        for (std::size_t i = 0; i + 1 < species.size(); ++i) {
            if (rest < weights[i])
                return species[i];
            rest -= weights[i];
        }
        return species.back();
    }

    TreeSize drawSize(Random& random) const {
        const double drawnHeight = height ? height->draw(random) : 0.0;
        const auto draw = [&](const std::optional<DrawnNumber>& metres,
                              const std::optional<DrawnNumber>& ratio) {
            return static_cast<float>(metres  ? metres->draw(random)
                                      : ratio ? drawnHeight * ratio->draw(random)
                                              : 0.0);
        };
        TreeSize size;
        size.height = static_cast<float>(drawnHeight);
        size.trunkDiameter = draw(trunkDiameter, trunkRatio);
        size.crownWidth = draw(crownWidth, crownRatio);
        return size;
    }
};

bool readArea(TableReader& table, Scatter& scatter) {
    std::vector<double> area;
    if (!table.readNumbers("area", area, 4, 4, worldCoordinates))
        return table.reportMissing("area");
    scatter.low = {area[0], area[1]};
    scatter.high = {area[2], area[3]};
    if (scatter.low.x < scatter.high.x && scatter.low.y < scatter.high.y)
        return true;
    table.problem("area", "expected [x0, y0, x1, y1] with x0 < x1 and y0 < y1");
    return false;
}

bool readSpacing(TableReader& table, const SceneMap& map, Scatter& scatter) {
    if (!table.read("spacing", scatter.spacing, within(0, 1e6)) || scatter.spacing == 0.0)
        return true;
    if (scatter.spacing < 0.001) {
        table.problem("spacing", "expected 0, or at least 0.001");
        return false;
    }
    if (map.crs())
        scatter.spacing *= map.metresAt(0.5 * (scatter.low + scatter.high), *map.crs());
    return true;
}

bool readMixture(TableReader& table, DocumentSpecies& species, Scatter& scatter) {
    std::vector<std::string> names;
    if (!table.read("species", names))
        for (std::size_t i = 0; i < species.declared(); ++i)
            names.push_back(species.all()[i].name);
    for (const std::string& name : names)
        if (const auto index = findSpecies(table, species, name))
            scatter.species.push_back(*index);
    if (names.empty())
        table.problem("species", "expected at least one species");
    scatter.weights.assign(names.size(), 1.0);
    table.readNumbers("weights", scatter.weights, names.size(), names.size(), above(0, 1e6));
    return !names.empty() && scatter.species.size() == names.size();
}

/// Reads a size in metres or as a ratio to the height, but not both.
void readSize(TableReader& table, const Scatter& scatter, const std::string& key,
              std::optional<DrawnNumber>& metres, const std::string& ratioKey,
              std::optional<DrawnNumber>& ratio) {
    metres = readDrawnNumber(table, key, treeRange(key));
    ratio = readDrawnNumber(table, ratioKey, above(0, 10));
    if (table.has(key) && ratio)
        table.problem(ratioKey, "give either this or " + key);
    else if (ratio && !scatter.height)
        table.problem(ratioKey, "needs height");
}

/// Reads all keys. @return false after a problem without which trees could be placed.
bool readKeys(TableReader& table, const TreeDefaults& defaults, const SceneMap& map, DocumentSpecies& species,
              Scatter& scatter) {
    bool complete = table.require("count", scatter.count, atLeast(1));
    complete &= readArea(table, scatter);
    complete &= readSpacing(table, map, scatter);
    complete &= readMixture(table, species, scatter);
    scatter.height = readDrawnNumber(table, "height", treeRange("height"));
    readSize(table, scatter, "trunk_diameter", scatter.trunkDiameter, "trunk_ratio", scatter.trunkRatio);
    readSize(table, scatter, "crown_width", scatter.crownWidth, "crown_ratio", scatter.crownRatio);
    scatter.isOpenGrownGiven = table.read("open_grown", scatter.openGrown);
    scatter.leaves = defaults.leaves;
    table.read("leaves", scatter.leaves, treeRange("leaves"));
    scatter.seed = defaults.seed;
    table.read("seed", scatter.seed);
    return complete;
}

} // namespace

void readTree(TableReader& table, const TreeDefaults& defaults, DocumentSpecies& species,
              DocumentTrees& trees) {
    TreePlacement tree;
    std::string name;
    if (!trees.canAdd(1, table, ""))
        return table.ignoreRest();
    if (table.read("species", name))
        tree.species = findSpecies(table, species, name).value_or(0);
    else if (species.declared() > 1)
        table.reportMissing("species");

    std::vector<double> position;
    if (table.readNumbers("position", position, 2, 3, worldCoordinates))
        tree.position = {position[0], position[1], position.size() > 2 ? position[2] : 0.0};
    else
        table.reportMissing("position");
    tree.leaves = defaults.leaves;
    tree.seed = defaults.seed + static_cast<std::uint32_t>(trees.size());
    readKeys(table, tree);
    if (!tree.name.empty() && !trees.reserveName(tree.name))
        table.problem("id", "the id " + inQuotes(tree.name) + " is taken already");
    const bool hasGrowingSpace = table.has("open_grown") || table.has("at_edge");
    trees.add(tree, position.size() == 2, {!hasGrowingSpace, !table.has("heading"), !table.has("seed")});
}

void readScatter(TableReader& table, const TreeDefaults& defaults, const SceneMap& map,
                 DocumentSpecies& species, DocumentTrees& trees) {
    Scatter scatter;
    if (!readKeys(table, defaults, map, species, scatter) ||
        !trees.canAdd(static_cast<std::uint64_t>(scatter.count), table, "count"))
        return;
    const auto reportFull = [&](const std::string& fitting) {
        table.problem("spacing", "only " + fitting + " of " + std::to_string(scatter.count) +
                                     " trees fit into the area with this spacing");
    };
    const double saturation = scatter.saturation();
    if (scatter.count > saturation + 3.0 * std::sqrt(saturation))
        return reportFull("about " + numberText(std::floor(saturation)));
    Random random(scatter.seed);
    SpacedPoints places(scatter.spacing);
    for (int i = 0; i < scatter.count; ++i) {
        const auto place = scatter.drawPlace(places, random);
        if (!place)
            return reportFull(std::to_string(i));
        trees.add(scatter.drawTree(*place, random), true, {!scatter.isOpenGrownGiven});
    }
}

} // namespace osgTreeWind
