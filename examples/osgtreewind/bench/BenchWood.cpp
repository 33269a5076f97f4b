// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchWood.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>

#include <cmath>

using namespace osgTreeWind;

glm::dvec3 placeInRows(std::size_t tree, std::size_t count, double apart) {
    const auto perRow = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    const std::size_t row = tree / perRow, column = tree % perRow;
    return {apart * static_cast<double>(column), apart * static_cast<double>(row), 0.0};
}

WindFieldPtr createSeries() {
    WindSeries series;
    for (int i = 0; i < 1000; ++i) {
        series.times.push_back(i);
        series.velocities.emplace_back(5.0 + math::sin(0.1 * i), math::cos(0.1 * i), 0.0);
    }
    series.profile = LogProfile{10.0, 0.5};
    return TimeSeriesWind::create(series).value();
}

ForestDescription createWood(std::size_t trees) {
    ForestDescription forest;
    forest.wind = createSeries();
    for (const char* name : {"Norway spruce", "Scots pine", "beech", "oak", "silver birch"}) {
        forest.species.push_back(*findSpecies(name));
        forest.species.back().shapes = 3;
    }
    Random random(8);
    for (std::size_t i = 0; i < trees; ++i) {
        TreePlacement tree;
        tree.species = random.next() % forest.species.size();
        tree.position = placeInRows(i, trees, 4.0);
        tree.heading = 6.28f * random.uniform();
        tree.seed = static_cast<std::uint32_t>(i);
        tree.size.height = 4.0f * math::pow(8.0f, random.uniform());
        tree.size.trunkDiameter = tree.size.height * (0.017f + 0.022f * random.uniform()); // as on the campus
        tree.size.crownWidth = tree.size.height * (0.25f + 0.5f * random.uniform());
        forest.trees.push_back(tree);
    }
    return forest;
}
