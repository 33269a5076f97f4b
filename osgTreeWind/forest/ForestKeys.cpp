// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/ForestKeys.h>

#include <osgTreeWind/base/Number.h>

namespace osgTreeWind {

template <>
const Keys& keysOf<DrawingOptions>() {
    using P = DrawingOptions;
    static const Keys keys = {
        {"tiers", at<&P::tiers>, {}, "Whether trees that look small have less detail"},
        {"full", at<&P::full>, above(0, 100000),
         "Height from which all leaf cards are drawn; from four times this height, also all vertices",
         "pixels"},
        {"reduced", at<&P::reduced>, above(0, 100000),
         "Height from which the number of leaf cards grows, up to all at `full`; below it, trees have the "
         "fewest",
         "pixels"},
        {"impostor", at<&P::impostor>, within(0, 100000),
         "Height below which a tree is drawn as a picture (impostor); 0: no impostors", "pixels"},
        {"blend", at<&P::blend>, within(0, 0.9),
         "Width of the cross-fade between two levels, as a share of the threshold"},
        {"budget", at<&P::budget>, within(0, 10000),
         "Target duration of a frame; 0: none. If frames take longer, trees get the detail of smaller ones, "
         "down to a quarter of their height",
         "ms"},
        {"exposure", at<&P::exposure>, within(0, 1000),
         "Factor on colours; 0: that of the define `EXPOSURE`, or 3. Has no effect under `FILM`"},
    };
    return keys;
}

template <>
const Keys& keysOf<ForestDescription>() {
    using P = ForestDescription;
    static const Keys keys = {
        {"law",
         at<&P::law>,
         {},
         "Law by which trees move",
         "",
         {{"modal", static_cast<int>(MotionLaw::Modal)},
          {"thesis", static_cast<int>(MotionLaw::Thesis)},
          {"thesis-smooth", static_cast<int>(MotionLaw::ThesisSmooth)}}},
        {"gain", at<&P::gain>, gains, "Factor on the bending of trees under `\"modal\"`; 1 is physical"},
        {"damage",
         at<&P::damage>,
         {},
         "Whether the wind brings down trees, boughs and autumn leaves ([risk.md](risk.md)); `\"modal\"` "
         "only"},
    };
    return keys;
}

std::string wordOf(MotionLaw law) {
    for (const auto& [word, value] : keyAt(keysOf<ForestDescription>(), "law").words)
        if (value == static_cast<int>(law))
            return word;
    return {};
}

const Keys& forestFileKeys() {
    static const Keys keys = {
        {"crs",
         at<&ForestDescription::crs>,
         {},
         "Projection of world coordinates, in metres, such as `\"EPSG:25832\"`"},
        {"host_crs",
         at<&ForestDescription::hostCrs>,
         {},
         "Projection of the host program's scene; a forest loaded as a model then stands at its place in "
         "that scene"},
        {"step", at<&ForestDescription::step>, frameSteps,
         "Simulated time per frame, for repeatable pictures; 0 uses the viewer's time. The environment "
         "variable `OSGTREEWIND_STEP` overrides it",
         "s"},
    };
    return keys;
}

template <>
const Keys& keysOf<EstimatedSizes>() {
    using P = EstimatedSizes;
    static const Keys keys = {
        {"height", at<&P::height>, {}, "Whether the height was [estimated](#sizes-that-are-not-measured)"},
        {"trunk_diameter", at<&P::trunkDiameter>, {}, "Whether the trunk diameter was estimated"},
        {"crown_width", at<&P::crownWidth>, {}, "Whether the crown width was estimated"},
    };
    return keys;
}

template <>
const Keys& keysOf<TreePlacement>() {
    using P = TreePlacement;
    static const Keys keys = {
        {"height", at<&P::size, &TreeSize::height>, above(0, 150), "Total height", "m"},
        {"trunk_diameter", at<&P::size, &TreeSize::trunkDiameter>, above(0, 20),
         "Stem diameter at breast height (DBH)", "m"},
        {"crown_width", at<&P::size, &TreeSize::crownWidth>, above(0, 150),
         "Mean of the crown's east-west and north-south widths", "m"},
        {"open_grown",
         at<&P::openGrown>,
         {},
         "Whether the tree stands free, so that its crown is deeper, and wider unless `crown_width` is "
         "given. Without this key and `at_edge`, the neighbours decide for trees with a `[species.habit]`"},
        {"at_edge",
         at<&P::atEdge>,
         {},
         "Whether the tree stands at the edge of a wood, with a deep crown toward its `heading`"},
        {"leaves", at<&P::leaves>, within(0, 1),
         "Share of its leaves that the tree bears; overrides `motion.leaves`"},
        {"heading", at<&P::heading>, within(-1e6, 1e6),
         "Rotation about the vertical, counter-clockwise from above", "degrees"},
        {"seed",
         at<&P::seed>,
         {},
         "Seed of shape and motion; without it, the file's `seed` plus the tree's index, plus up to 63 so "
         "that neighbours differ"},
        {"id", at<&P::name>, {}, "Unique name, any text"},
        {"estimated", at<&P::estimated>, {}, ""},
    };
    return keys;
}

std::vector<KeyConflict> conflictsOf(const DrawingOptions& drawing) {
    std::vector<KeyConflict> conflicts;
    const auto expectBelow = [&](const char* key, float low, const char* other, float high) {
        if (!(low < high))
            conflicts.push_back({key, other,
                                 std::string("expected ") + key + " below " + other + ", found " +
                                     numberText(low) + " and " + numberText(high)});
    };
    expectBelow("reduced", drawing.reduced, "full", drawing.full);
    expectBelow("impostor", drawing.impostor, "reduced", drawing.reduced);
    return conflicts;
}

} // namespace osgTreeWind
