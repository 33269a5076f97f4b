// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <cstddef>

/// Position of one of `count` trees in a square of rows. @param apart distance between trees, metres.
glm::dvec3 placeInRows(std::size_t tree, std::size_t count, double apart);

/// A wind record of 1000 s that swings to and fro.
osgTreeWind::WindFieldPtr createSeries();

/// A forest of spruce, pine, beech, oak and birch in rows, three shapes each, 4 to 32 m high, in that wind.
osgTreeWind::ForestDescription createWood(std::size_t trees);
