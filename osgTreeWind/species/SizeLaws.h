// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/species/Species.h>

#include <string>

namespace osgTreeWind {

/// A size, and flags for its estimated values.
struct SizeEstimate {
    TreeSize size;
    EstimatedSizes estimated;
    double diameterSpread = 0.0; ///< Standard deviation of ln(diameter); 0 if the diameter is given.
};

/// Estimates the missing sizes of a tree from the laws of its species, with their random spread. Height and
/// diameter follow from each other, the crown from the diameter, and the diameter also from the crown.
/// Without any size, the height varies about usualHeight(). Sizes without a law stay 0.
/// @param id of the tree; it determines the random residuals.
SizeEstimate estimateSize(const TreeSize& given, const Species& species, bool openGrown,
                          const std::string& id);

/// Random deviation of a tree from a law, in standard deviations: a normal distribution truncated at 2 and
/// widened so that its standard deviation stays 1.
double residual(const std::string& id, const std::string& quantity);

/// Limits of height / diameter in estimates. Trees with measured sway have 16 to 154 (Jackson et al. 2021),
/// 99 % of the Urban Tree Database 11 to 118, and of BAAD 24 to 226.
constexpr double minSlenderness = 15.0, maxSlenderness = 150.0;

} // namespace osgTreeWind
