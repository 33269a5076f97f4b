// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindKeys.h>

namespace osgTreeWind {

template <>
const Keys& keysOf<WindGusts>() {
    using P = WindGusts;
    static const Keys keys = {
        {"intensity", at<&P::intensity>, within(0, 1),
         "Strength of [gusts](#gusts): their standard deviation along the wind over the mean speed, at "
         "`height` or else at 10 m; without it, 0.2 for `\"gusts\"` and 0 (no gusts) for other kinds. It "
         "is 0.15 in open country, 0.25 in suburbs, and 0.3 and more over a forest. Across the wind, 0.8 "
         "of this value; upward, 0.5"},
        {"length_scale", at<&P::lengthScale>, within(1, 1e5),
         "Integral length scale of the gusts along the wind. The largest gusts are longer", "m"},
        {"seed", at<&P::seed>, {}, "Seed of the gusts; without it, the `seed` of the file"},
    };
    return keys;
}

template <>
const Keys& keysOf<GridWind::Grid>() {
    using P = GridWind::Grid;
    static const Keys keys = {
        {"corner", at<&P::origin>, worldCoordinates,
         "Position of the first point relative to the forest's origin", "m"},
        {"points", at<&P::points>, gridPoints, "Number of points east, north and up"},
        {"cell", at<&P::cell>, gridCells, "Distances between neighbouring points", "m"},
        {"times", at<&P::times>, {}, "Time of each set of values", "s"},
        {"heights", at<&P::heights>, {}, "Heights of layers that are not evenly spaced", "m"},
        {"above_ground", at<&P::aboveGround>, {}, "Whether heights count from the ground below each place"},
        {"roughness", at<&P::roughness>, within(0, 100), "Roughness length of the ground", "m"},
        {"values", at<&P::values>, windSpeeds, "Velocity components u, v, w of each point", "m/s"},
        {"deviations", at<&P::deviations>, within(0, 200),
         "Standard deviation of the turbulence along the wind at each point", "m/s"},
    };
    return keys;
}

template <>
const Keys& keysOf<ThesisWind::Array>() {
    using P = ThesisWind::Array;
    static const Keys keys = {
        {"width", at<&P::width>, gridPoints, "Number of cells along thesis x (east)"},
        {"length", at<&P::length>, gridPoints, "Number of cells along thesis z (south)"},
        {"corner", at<&P::origin>, worldCoordinates,
         "Position of the array's corner relative to the forest's origin", "m"},
        {"values", at<&P::values>, windSpeeds, "Velocity components in thesis axes", "m/s"},
    };
    return keys;
}

template <>
const Keys& keysOf<WindSeries>() {
    using P = WindSeries;
    static const Keys keys = {
        {"times", at<&P::times>, {}, "Times of the velocities", "s"},
        {"velocities", at<&P::velocities>, windSpeeds, "Velocities toward east, north, up, one for each time",
         "m/s"},
        {"repeat", at<&P::repeat>, {}, "Whether the record starts again after its last time"},
    };
    return keys;
}

template <>
const Keys& keysOf<LogProfile>() {
    using P = LogProfile;
    static const Keys keys = {
        {"height", at<&P::height>, above(0, 10000), "Height of the measurement above the ground", "m"},
        {"roughness", at<&P::roughness>, above(0, 100), "Roughness length of the ground", "m"},
    };
    return keys;
}

template <>
const Keys& keysOf<CanopySettings>() {
    using P = CanopySettings;
    static const Keys keys = {
        {"canopy",
         at<&P::source>,
         {},
         "Trees that change the wind: none, those of the forest, or a given uniform, infinite stand",
         "",
         {{"none", static_cast<int>(CanopySource::None)},
          {"forest", static_cast<int>(CanopySource::Forest)},
          {"given", static_cast<int>(CanopySource::Given)},
          {"auto", static_cast<int>(CanopySource::None)}}}, // until a reader of files decides
        {"canopy_height", at<&P::height>, within(1, 150), "Height of the given stand", "m"},
        {"canopy_frontal_area", at<&P::frontalArea>, within(0.01, 20),
         "Frontal area index of the given stand: half of its leaf area plus the frontal area of its wood, "
         "per ground area"},
        {"canopy_reference", at<&P::reference>, within(1, 1000),
         "Height above the ground at which the wind of open country is given; raised to the tree tops if "
         "they are higher",
         "m"},
        {"canopy_seed", at<&P::seed>, {}, "Seed of the turbulence among the trees"},
        {"canopy_reach", at<&P::reach>, within(0, 1000),
         "With `\"forest\"`, radius of the area that counts as one stand; 0: twice the mean tree height. "
         "`osgtreewind tile` writes this key and the next three",
         "m"},
        {"canopy_usual_height", at<&P::usualHeight>, within(0, 150),
         "With `\"forest\"`, height of the stand that sets the size and speed of gusts; 0: the mean of all "
         "stands",
         "m"},
        {"canopy_usual_frontal_area", at<&P::usualFrontalArea>, within(0, 20),
         "Frontal area index of that stand; 0: the mean of all stands"},
        {"canopy_extent", at<&P::extent>, within(0, 1e6),
         "Side of a square as large as the forest; trees slow the wind more in a larger one. 0: that of the "
         "forest's own trees, or endless for a given stand; 1 for a wind measured above the trees",
         "m"},
    };
    return keys;
}

template <>
const Keys& keysOf<WindClock>() {
    using P = WindClock;
    static const Keys keys = {
        {"start", at<&P::start>, within(-1e12, 1e12), "Time of the wind data at scene time 0", "s"},
        {"time_scale", at<&P::scale>, within(-1e6, 1e6),
         "Seconds of wind data per second of the scene: 60 shows an hour in a minute, 0 freezes the wind"},
    };
    return keys;
}

template <>
const Keys& keysOf<WindAdjustment>() {
    using P = WindAdjustment;
    static const Keys keys = {
        {"strength", at<&P::strength>, within(0, 10), "Factor applied to all velocities"},
        {"turn", at<&P::turn>, within(-360, 360),
         "Clockwise rotation of all velocities; positions do not turn", "degrees"},
    };
    return keys;
}

template <>
const Keys& keysOf<WindSource>() {
    using P = WindSource;
    static const Keys keys = {
        {"kind",
         at<&P::kind>,
         {},
         "Kind of source",
         "",
         numberedFromZero({"rotor", "jet", "vortex", "shelter", "vehicle", "explosion"})},
        {"place", at<&P::position>, worldCoordinates, "Position relative to the forest's origin", "m"},
        {"velocity", at<&P::velocity>, within(-1000, 1000),
         "Velocity of the source; vehicles move horizontally, explosions do not move", "m/s"},
        {"radius", at<&P::radius>, above(0, 1000),
         "Radius of a rotor, shelter or jet mouth, or of the circle where a vortex is fastest; half the "
         "width of a "
         "vehicle",
         "m"},
        {"thrust", at<&P::thrust>, within(0, 1e7), "Thrust of a rotor: the weight of the helicopter", "N"},
        {"speed", at<&P::speed>, windSpeeds,
         "Speed of the air at the mouth of a jet; largest speed in a vortex, negative if clockwise", "m/s"},
        {"toward", at<&P::toward>, within(-360, 360), "Direction in which a jet blows, clockwise from north",
         "degrees"},
        {"elevation", at<&P::elevation>, within(-90, 90), "Angle of a jet above the horizontal", "degrees"},
        {"height", at<&P::height>, above(0, 10000), "Height of a vortex, shelter or vehicle", "m"},
        {"length", at<&P::length>, above(0, 1000), "Length of a vehicle", "m"},
        {"drag_area", at<&P::dragArea>, within(0, 1000),
         "Drag coefficient of a vehicle times its frontal area: 6 for a lorry, 0.7 for a car", "m^2"},
        {"share", at<&P::share>, within(0, 1), "Share of the wind that remains in a shelter"},
        {"charge", at<&P::charge>, above(0, 1e9), "Mass of TNT", "kg"},
        {"time", at<&P::time>, within(-1e9, 1e9), "Scene time of an explosion", "s"},
        {"turbulence", at<&P::turbulence>, within(0, 1),
         "Turbulence intensity of the flow that the source adds"},
    };
    return keys;
}

} // namespace osgTreeWind
