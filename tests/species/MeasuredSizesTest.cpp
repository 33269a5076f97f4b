// SPDX-License-Identifier: MIT
#include <osgTreeWind/species/SizeLaws.h>

#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>

#include <tests/TestData.h>

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace osgTreeWind;

namespace {

struct Pair {
    std::string species;
    double height, diameter; // metres
    bool openGrown;
};

struct Scatter {
    std::size_t trees = 0;
    double bias = 0.0, deviation = 0.0;
};

/// Deviations of logarithms of measured heights from the laws. The bias is above 0 if the laws are too low.
/// @param fallback species of trees whose species and genus are not built in.
Scatter scatterOf(const std::vector<Pair>& pairs, const Species& fallback) {
    Scatter scatter;
    double sum = 0.0, squares = 0.0;
    for (const Pair& pair : pairs) {
        Species species = findSpecies(pair.species).value_or(fallback);
        species.height.spread = species.height.openSpread = 0.0f;
        TreeSize size;
        size.trunkDiameter = static_cast<float>(pair.diameter);
        const double law = estimateSize(size, species, pair.openGrown, "").size.height;
        const double off = std::log(pair.height / law);
        sum += off, squares += off * off;
    }
    scatter.trees = pairs.size();
    scatter.bias = sum / static_cast<double>(pairs.size());
    scatter.deviation = std::sqrt(squares / static_cast<double>(pairs.size()) - scatter.bias * scatter.bias);
    return scatter;
}

/// Reads the trees of at least 5 cm with height and diameter.
/// @param names columns of species, height and diameter. @param unit of the diameter, metres.
std::vector<Pair> pairsOf(const std::string& path, const std::vector<std::string>& names, double unit,
                          const std::function<bool(const CsvTable&, const CsvTable::Row&)>& accepts,
                          bool openGrown) {
    std::ifstream file(path);
    const auto read = readCsvTable(file, path, ',');
    std::vector<Pair> pairs;
    if (!read)
        return pairs;
    const CsvTable& table = read.value();
    std::vector<std::size_t> columns;
    for (const std::string& name : names)
        columns.push_back(static_cast<std::size_t>(
            std::find(table.columns.begin(), table.columns.end(), name) - table.columns.begin()));
    for (const CsvTable::Row& row : table.rows) {
        const auto height = table.number(row, columns[1]), diameter = table.number(row, columns[2]);
        if (height && diameter && diameter.value() * unit >= 0.05 && accepts(table, row))
            pairs.push_back({row.cells[columns[0]], height.value(), diameter.value() * unit, openGrown});
    }
    return pairs;
}

/// Standard deviation of ln(diameter) about a straight line over ln(height).
double regressionSpread(const std::vector<Pair>& pairs) {
    double n = static_cast<double>(pairs.size()), x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
    for (const Pair& pair : pairs) {
        const double h = std::log(pair.height), d = std::log(pair.diameter);
        x += h / n, y += d / n, xx += h * h / n, xy += h * d / n, yy += d * d / n;
    }
    return std::sqrt(yy - y * y - (xy - x * y) * (xy - x * y) / (xx - x * x));
}

/// Prints the scatter and compares it with docs/validation.md.
void expectScatter(const std::string& name, const std::vector<Pair>& pairs, double bias, double deviation,
                   const char* fallback = "broadleaf") {
    const Scatter found = scatterOf(pairs, *findSpecies(fallback));
    std::printf("%s: %zu trees, bias %.3f, scatter %.3f\n", name.c_str(), found.trees, found.bias,
                found.deviation);
    EXPECT_NEAR(found.bias, bias, 0.005) << name << ": docs/validation.md";
    EXPECT_NEAR(found.deviation, deviation, 0.005) << name << ": docs/validation.md";
}

/// Hides the diameters. Compares the basal area of the estimates, mean of 20 draws, and their spread at one
/// height with docs/validation.md and with a regression.
void expectDiameters(const std::string& name, const std::vector<Pair>& pairs, double basalArea,
                     const char* fallback = "broadleaf") {
    constexpr int draws = 20;
    double measured = 0.0, estimated = 0.0, variance = 0.0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Species species = findSpecies(pairs[i].species).value_or(*findSpecies(fallback));
        TreeSize given;
        given.height = static_cast<float>(pairs[i].height);
        for (int draw = 0; draw < draws; ++draw) {
            const SizeEstimate tree = estimateSize(given, species, pairs[i].openGrown,
                                                   std::to_string(draw) + ' ' + std::to_string(i));
            estimated += std::pow(static_cast<double>(tree.size.trunkDiameter), 2.0) / draws;
            variance += tree.diameterSpread * tree.diameterSpread / static_cast<double>(draws * pairs.size());
        }
        measured += pairs[i].diameter * pairs[i].diameter;
    }
    std::printf("%s: basal area %.2f of measured, spread %.2f, of a regression %.2f\n", name.c_str(),
                estimated / measured, std::sqrt(variance), regressionSpread(pairs));
    EXPECT_NEAR(estimated / measured, basalArea, 0.02) << name << ": docs/validation.md";
    EXPECT_NEAR(std::sqrt(variance), regressionSpread(pairs), 0.08) << name;
}

bool acceptAll(const CsvTable&, const CsvTable::Row&) {
    return true;
}

} // namespace

TEST(MeasuredSizes, CampusTreesMatchTheLaws) {
    REQUIRE_REAL_DATA(path, "utah_campus/utah_campus_trees.csv");
    expectScatter("campus", pairsOf(path, {"AESciName", "H", "dbh"}, 1.0, acceptAll, true), 0.080, 0.154);
}

TEST(MeasuredSizes, ForestTreesMatchTheLaws) {
    REQUIRE_REAL_DATA(path, "scbi/scbi_joined_xy_height_dbh.csv");
    expectScatter("forest", pairsOf(path, {"species", "height.m", "dbh_cm"}, 0.01, acceptAll, false), -0.019,
                  0.269);
    expectDiameters("forest", pairsOf(path, {"species", "height.m", "dbh_cm"}, 0.01, acceptAll, false), 0.96);
}

TEST(MeasuredSizes, TreesWithMeasuredSwayMatchTheLaws) {
    REQUIRE_REAL_DATA(path, "sway/SwayFrequencies_odd.csv");
    for (const auto& [clade, environment, bias, deviation, basalArea] :
         {std::tuple("Conifer", "Forest", -0.075, 0.198, 1.22),
          {"Broadleaf", "Forest", 0.051, 0.305, 1.32},
          {"Broadleaf", "Open", 0.158, 0.285, 1.35}}) {
        const auto accepts = [&, clade = clade, environment = environment](const CsvTable&,
                                                                           const CsvTable::Row& row) {
            return row.cells[0] == clade && row.cells[1] == environment;
        };
        const bool open = environment == std::string("Open");
        const std::string name = std::string("sway, ") + clade + ' ' + environment;
        const auto pairs = pairsOf(path, {"species", "height_m", "dbh_cm"}, 0.01, accepts, open);
        const char* const fallback = clade == std::string("Conifer") ? "conifer" : "broadleaf";
        expectScatter(name, pairs, bias, deviation, fallback);
        expectDiameters(name, pairs, basalArea, fallback);
    }
}
