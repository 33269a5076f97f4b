// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrownForm.h>
#include <osgTreeWind/growth/GrowthGoal.h>

namespace osgTreeWind {

/// Sets the radii of a form by the pipe model (Shinozaki et al. 1964): a radius is a power of the number of
/// shoot tips that the wood bears, scaled to the trunk's diameter. The trunk tapers as (height - z)^0.6, like
/// measured stems with a form factor of 0.5. An axis gets thinner from base to tip, and is thinner than 0.9
/// of its parent. @param twigRadius radius of the thinnest shoots, metres.
void setRadii(GrownForm& form, const GrowthGoal& goal, float twigRadius);

} // namespace osgTreeWind
