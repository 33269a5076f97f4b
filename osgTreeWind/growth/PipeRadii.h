// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrownForm.h>
#include <osgTreeWind/growth/GrowthGoal.h>

namespace osgTreeWind {

/// Radii of wood: what bears more shoots is thicker, by a power that gives the trunk its diameter (pipe
/// model, Shinozaki et al. 1964). The trunk itself tapers as stems are measured, by (height - z)^0.6, which
/// makes a form factor of 0.5. An axis gets thinner from foot to end, and is below 0.9 of what bears it.
/// @param twigRadius of its thinnest shoots, metres.
void setRadii(GrownForm& form, const GrowthGoal& goal, float twigRadius);

} // namespace osgTreeWind
