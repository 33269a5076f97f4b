// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/ForestFields.h>

#include <osgTreeWind/base/Number.h>

namespace osgTreeWind {

template <>
const Fields& fieldsOf<DrawingOptions>() {
    using P = DrawingOptions;
    static const Fields fields = {
        {"tiers", memberOf<&P::tiers>, {}, "", "false: everything in full"},
        {"full", memberOf<&P::full>, above(0, 100000), "pixels", "from this height on: every vertex"},
        {"reduced", memberOf<&P::reduced>, above(0, 100000), "pixels",
         "from this height on: reduced once, to about a fifth of the vertices"},
        {"impostor", memberOf<&P::impostor>, within(0, 100000), "pixels",
         "from this height on: reduced twice, to about a twentieth; below: a picture of the tree that leans "
         "with it. 0: no pictures"},
        {"blend", memberOf<&P::blend>, within(0, 0.9), "",
         "share of a threshold over which one form gives way to the next, pixel by pixel"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<ForestDescription>() {
    using P = ForestDescription;
    static const Fields fields = {
        {"law",
         memberOf<&P::law>,
         {},
         "",
         "how trees answer the wind",
         {{"modal", static_cast<int>(MotionLaw::Modal)},
          {"damped", static_cast<int>(MotionLaw::Damped)},
          {"thesis", static_cast<int>(MotionLaw::Thesis)},
          {"thesis-smooth", static_cast<int>(MotionLaw::ThesisSmooth)}}},
        {"gain", memberOf<&P::gain>, gains, "",
         "on how far the laws `\"modal\"` and `\"damped\"` bend trees: 1 is physical; more exaggerates for "
         "the eye, at the same pace"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<TreePlacement>() {
    using P = TreePlacement;
    static const Fields fields = {
        {"height", memberOf<&P::size, &TreeSize::height>, above(0, 150), "m", "ground to highest point"},
        {"trunk_diameter", memberOf<&P::size, &TreeSize::trunkDiameter>, above(0, 20), "m",
         "at breast height"},
        {"crown_width", memberOf<&P::size, &TreeSize::crownWidth>, above(0, 150), "m",
         "mean of east-west and north-south"},
        {"open_grown",
         memberOf<&P::openGrown>,
         {},
         "",
         "it stands by itself: the crown of a built-in species, where `crown_width` is not given, is wider "
         "than in a forest"},
        {"leaves", memberOf<&P::leaves>, within(0, 1), "",
         "share of its leaves that it bears: their mass, drag and damping; else `motion.leaves`"},
        {"heading", memberOf<&P::heading>, within(-360, 360), "degrees",
         "turn about the vertical, counter-clockwise from above"},
        {"seed",
         memberOf<&P::seed>,
         {},
         "",
         "picks the shape and its motion; without it `seed` and its place in the file, from 0"},
        {"id", memberOf<&P::name>, {}, "", "what it is called, any text; no two alike"},
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
