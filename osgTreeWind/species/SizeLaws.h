// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/species/Species.h>

#include <string>

namespace osgTreeWind {

/// A size, and what of it was estimated.
struct SizeEstimate {
    TreeSize size;
    EstimatedSizes estimated;
};

/// What was not measured of a tree, by the laws of its species with their spread. Height and diameter follow
/// from each other; a crown from the diameter, and only where it alone is given the other way round. Where
/// nothing is given a grown shape's own height is spread as heights are, and the rest stays in proportion.
/// What no law tells stays 0.
/// @param id what tells trees apart: one id draws the same residuals always, whatever stands beside it.
SizeEstimate estimateSize(const TreeSize& given, const Species& species, bool openGrown,
                          const std::string& id);

/// What a tree is off a law, in standard deviations: normal, but cut at two and by so much wider that they
/// stay what they are.
double residual(const std::string& id, const std::string& quantity);

/// Height over diameter of what is estimated. Trees whose sway was measured have 16 to 154 (Jackson et al.
/// 2021), all but 1 % of those of the Urban Tree Database 11 to 118, and of BAAD 24 to 226.
constexpr double stoutestEstimate = 15.0, slenderestEstimate = 150.0;

} // namespace osgTreeWind
