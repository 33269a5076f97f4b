// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindFields.h>

namespace osgTreeWind {

template <>
const Fields& fieldsOf<GustWind::Parameters>() {
    using P = GustWind::Parameters;
    static const Fields fields = {
        {"intensity", at<&P::intensity>, within(0, 1),
         "standard deviation of the wind along the mean over the mean; across 0.8 and upward 0.5 of that. "
         "Open country 0.15, suburbs 0.25, over a forest 0.3 and more"},
        {"length_scale", at<&P::lengthScale>, within(1, 1e5), "size of the largest gusts along the wind",
         "m"},
        {"seed", at<&P::seed>, {}, "one seed, one wind; without it the `seed` of the file"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<GridWind::Grid>() {
    using P = GridWind::Grid;
    static const Fields fields = {
        {"corner", at<&P::origin>, worldCoordinates,
         "the same from the forest's origin, in place of `origin`", "m"},
        {"points", at<&P::points>, gridPoints, "points east, north and up"},
        {"cell", at<&P::cell>, gridCells, "distances between points", "m"},
        {"times", at<&P::times>, {}, "when each layer of values holds", "s"},
        {"heights", at<&P::heights>, {}, "heights of layers that are not even", "m"},
        {"above_ground", at<&P::aboveGround>, {}, "heights count from the ground below each place"},
        {"roughness", at<&P::roughness>, within(0, 100), "of the ground", "m"},
        {"values", at<&P::values>, windSpeeds, "u, v, w of each point", "m/s"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<ForestWind::Array>() {
    using P = ForestWind::Array;
    static const Fields fields = {
        {"width", at<&P::width>, gridPoints, "cells along thesis x (east)"},
        {"length", at<&P::length>, gridPoints, "cells along thesis z (south)"},
        {"corner", at<&P::origin>, worldCoordinates, "position of the array's corner", "m"},
        {"values", at<&P::values>, windSpeeds, "components in thesis axes", "m/s"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<WindSeries>() {
    using P = WindSeries;
    static const Fields fields = {
        {"times", at<&P::times>, {}, "of the records", "s"},
        {"velocities", at<&P::velocities>, windSpeeds, "toward east, north, up; one for each time", "m/s"},
        {"repeat", at<&P::repeat>, {}, "start again after the last time"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<LogProfile>() {
    using P = LogProfile;
    static const Fields fields = {
        {"height", at<&P::height>, above(0, 10000), "", "m"},
        {"roughness", at<&P::roughness>, above(0, 100), "", "m"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<WindCanopy>() {
    using P = WindCanopy;
    static const Fields fields = {
        {"canopy",
         at<&P::source>,
         {},
         "whether the wind is continued down into the trees: `\"none\"` takes it as it is, which is right "
         "for one that knows of trees; `\"forest\"` has the forest's own trees shelter one another; "
         "`\"given\"` puts each into a stand that goes on to all sides",
         "",
         {{"none", static_cast<int>(CanopySource::None)},
          {"forest", static_cast<int>(CanopySource::Forest)},
          {"given", static_cast<int>(CanopySource::Given)}}},
        {"canopy_height", at<&P::height>, within(1, 150), "of a given stand", "m"},
        {"canopy_frontal_area", at<&P::frontalArea>, within(0.01, 20),
         "frontal area index of a given stand: half of the area of its leaves, and that of its wood seen "
         "from the side, over the ground's"},
        {"canopy_reference", at<&P::reference>, within(1, 1000),
         "height above the ground at which the wind is given; at least the top of the trees", "m"},
        {"canopy_seed", at<&P::seed>, {}, "one seed, one turbulence"},
        {"canopy_reach", at<&P::reach>, within(0, 1000),
         "how far around its middle a stand of the forest's own trees reaches; 0: twice their mean height. "
         "`tile` writes it, so that parts of a world have the stands of the whole",
         "m"},
        {"canopy_usual_height", at<&P::usualHeight>, within(0, 150),
         "height of the stand that gusts among the forest's own trees have their size and pace from; 0: the "
         "mean of their stands. `tile` writes it, too",
         "m"},
        {"canopy_usual_frontal_area", at<&P::usualFrontalArea>, within(0, 20),
         "frontal area index of that stand; 0: the mean of theirs"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<WindClock>() {
    using P = WindClock;
    static const Fields fields = {
        {"start", at<&P::start>, within(-1e12, 1e12),
         "time of the wind data shown when the scene's time is 0", "s"},
        {"time_scale", at<&P::scale>, within(-1e6, 1e6),
         "seconds of wind data per second of the scene: 60 shows an hour in a minute, 0 stands still"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<WindAdjustment>() {
    using P = WindAdjustment;
    static const Fields fields = {
        {"strength", at<&P::strength>, within(0, 10), "factor of all velocities"},
        {"turn", at<&P::turn>, within(-360, 360), "turns all velocities clockwise, where they are",
         "degrees"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<WindSource>() {
    using P = WindSource;
    static const Fields fields = {
        {"kind",
         at<&P::kind>,
         {},
         "what it is",
         "",
         inOrder({"rotor", "jet", "vortex", "shelter", "vehicle", "explosion"})},
        {"place", at<&P::position>, worldCoordinates,
         "from the forest's origin, at time 0: a rotor's hub, a jet's mouth, the foot of a vortex or a "
         "shelter, the ground below the middle of a vehicle's rear, a charge",
         "m"},
        {"velocity", at<&P::velocity>, within(-1000, 1000), "it moves with", "m/s"},
        {"radius", at<&P::radius>, above(0, 1000),
         "of a rotor, a mouth or a shelter; where a vortex is fastest; half of a vehicle's width", "m"},
        {"thrust", at<&P::thrust>, within(0, 1e7), "of a rotor: the weight that hovers", "N"},
        {"speed", at<&P::speed>, windSpeeds,
         "at a jet's mouth; the fastest of a vortex, counter-clockwise from above or, negative, clockwise",
         "m/s"},
        {"toward", at<&P::toward>, within(-360, 360), "where a jet blows, clockwise from north", "degrees"},
        {"elevation", at<&P::elevation>, within(-90, 90), "and upward", "degrees"},
        {"height", at<&P::height>, above(0, 10000), "up to which a vortex or a shelter reaches; of a vehicle",
         "m"},
        {"length", at<&P::length>, above(0, 1000), "of a vehicle", "m"},
        {"drag_area", at<&P::dragArea>, within(0, 1000),
         "of a vehicle: drag coefficient times frontal area; 6 of a lorry, 0.7 of a car", "m^2"},
        {"share", at<&P::share>, within(0, 1), "of the wind that a shelter leaves"},
        {"charge", at<&P::charge>, above(0, 1e9), "of an explosion: as much TNT", "kg"},
        {"time", at<&P::time>, within(-1e9, 1e9), "at which an explosion goes off", "s"},
        {"turbulence", at<&P::turbulence>, within(0, 1),
         "of what it adds: standard deviation of each component over the speed there"},
    };
    return fields;
}

} // namespace osgTreeWind
