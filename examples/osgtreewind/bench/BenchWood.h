// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <cstddef>

/// The place of one of `count` trees in a square of rows. @param apart metres from tree to tree.
glm::dvec3 placeInRows(std::size_t tree, std::size_t count, double apart);

/// A wind that swings for a thousand seconds, as a record has it.
osgTreeWind::WindFieldPtr createSeries();

/// A wood of spruce, pine, beech, oak and birch in rows, three shapes each, 4 to 32 m high, in that wind.
osgTreeWind::ForestDescription createWood(std::size_t trees);
