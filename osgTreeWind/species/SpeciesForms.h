// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeModel.h>

namespace osgTreeWind {

/// What a built-in kind of tree is shaped like, standing free in its middle age.
enum class SpeciesForm {
    Spruce,
    SitkaSpruce,
    DouglasFir,
    Fir,
    Hemlock,
    ScotsPine,
    LodgepolePine,
    CorsicanPine,
    RadiataPine,
    WhiteSpruce,
    BalsamFir,
    Larch,
    Conifer,
    Birch,
    Beech,
    Oak,
    Ash,
    Sycamore,
    RedMaple,
    RedOak,
    Aspen,
    Lime,
    Poplar,
    Plane,
    HoneyLocust,
    NorwayMaple,
    HorseChestnut,
    Ginkgo,
    Palm,
    Broadleaf,
};

/// Wood and leaves of a form, but for LeafParameters::area. Sources: docs/species.md.
TreeParameters speciesForm(SpeciesForm form);

} // namespace osgTreeWind
