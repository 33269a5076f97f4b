// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/ForestFields.h>

#include <osgTreeWind/base/Number.h>

namespace osgTreeWind {

template <>
const Fields& fieldsOf<DrawingOptions>() {
    using P = DrawingOptions;
    static const Fields fields = {
        {"tiers", at<&P::tiers>, {}, "false: everything in full"},
        {"full", at<&P::full>, above(0, 100000),
         "from this height on all leaf cards, and bark that is off by a few pixels at most; from four times "
         "it every vertex",
         "pixels"},
        {"reduced", at<&P::reduced>, above(0, 100000),
         "between `full` and this height ever fewer and larger leaf cards, and less bark; below: the fewest",
         "pixels"},
        {"impostor", at<&P::impostor>, within(0, 100000),
         "below this height: a picture of the tree that leans with it. 0: no pictures", "pixels"},
        {"blend", at<&P::blend>, within(0, 0.9),
         "share of a threshold over which one form gives way to the next, leaf card by leaf card, to a "
         "picture pixel by pixel"},
        {"budget", at<&P::budget>, within(0, 10000),
         "what the frame of a view is to take: where it takes longer, trees are drawn as if they were lower, "
         "down to a quarter of their height. 0: none",
         "ms"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<ForestDescription>() {
    using P = ForestDescription;
    static const Fields fields = {
        {"law",
         at<&P::law>,
         {},
         "how trees answer the wind",
         "",
         {{"modal", static_cast<int>(MotionLaw::Modal)},
          {"thesis", static_cast<int>(MotionLaw::Thesis)},
          {"thesis-smooth", static_cast<int>(MotionLaw::ThesisSmooth)}}},
        {"gain", at<&P::gain>, gains,
         "on how far the law `\"modal\"` bends trees: 1 is physical; more exaggerates for the eye, at the "
         "same pace"},
        {"damage",
         at<&P::damage>,
         {},
         "whether the wind brings trees down, and leaves in autumn (risk.md); law `\"modal\"` alone"},
    };
    return fields;
}

std::string wordOf(MotionLaw law) {
    for (const auto& [word, value] : fieldAt(fieldsOf<ForestDescription>(), "law").words)
        if (value == static_cast<int>(law))
            return word;
    return {};
}

const Fields& fieldsOfFile() {
    static const Fields fields = {
        {"crs",
         at<&ForestDescription::crs>,
         {},
         "coordinate reference system of the world: a map in metres, as PROJ calls it (`\"EPSG:25832\"`)"},
        {"host_crs",
         at<&ForestDescription::hostCrs>,
         {},
         "map of the scene that reads the file as a model, likewise: the forest then stands at its place "
         "there"},
        {"step", at<&ForestDescription::step>, frameSteps,
         "how long a frame lasts, whatever time the viewer gives; 0: the viewer's time counts", "s"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<EstimatedSizes>() {
    using P = EstimatedSizes;
    static const Fields fields = {
        {"height",
         at<&P::height>,
         {},
         "nobody measured it: it followed from the species, as sizes do that an inventory has not"},
        {"trunk_diameter", at<&P::trunkDiameter>, {}, "likewise"},
        {"crown_width", at<&P::crownWidth>, {}, "likewise"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<TreePlacement>() {
    using P = TreePlacement;
    static const Fields fields = {
        {"height", at<&P::size, &TreeSize::height>, above(0, 150), "ground to highest point", "m"},
        {"trunk_diameter", at<&P::size, &TreeSize::trunkDiameter>, above(0, 20), "at breast height", "m"},
        {"crown_width", at<&P::size, &TreeSize::crownWidth>, above(0, 150),
         "mean of east-west and north-south", "m"},
        {"open_grown",
         at<&P::openGrown>,
         {},
         "it stands by itself: its crown is as deep as its species grows, whatever `[species.crown]` says of "
         "a forest; that of a built-in species, where `crown_width` is not given, is wider than there. Where "
         "neither this nor `at_edge` is said of a tree that grows by light, its neighbours tell"},
        {"at_edge",
         at<&P::atEdge>,
         {},
         "it stands at the edge of a wood, which is open to where its `heading` points: there its crown is "
         "as deep as in the open"},
        {"leaves", at<&P::leaves>, within(0, 1),
         "share of its leaves that it bears: their mass, drag and damping; else `motion.leaves`"},
        {"heading", at<&P::heading>, within(-1e6, 1e6),
         "turn about the vertical, counter-clockwise from above", "degrees"},
        {"seed",
         at<&P::seed>,
         {},
         "picks the shape and its motion; without it `seed` and its place in the file, from 0, and up to 63 "
         "more where neighbours would have the same form"},
        {"id", at<&P::name>, {}, "what it is called, any text; no two alike"},
        {"estimated", at<&P::estimated>, {}, ""},
    };
    return fields;
}

std::vector<FieldConflict> conflictsOf(const DrawingOptions& drawing) {
    std::vector<FieldConflict> conflicts;
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
