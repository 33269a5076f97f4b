// SPDX-License-Identifier: MIT
#include <osgTreeWind/species/SpeciesFields.h>

namespace osgTreeWind {

template <>
const Fields& fieldsOf<HeightAllometry>() {
    using P = HeightAllometry;
    static const Fields fields = {
        {"scale", at<&P::scale>, within(0, 500),
         "height in a forest: `scale` times the diameter in metres to the power of `power`; 0 is not known",
         "m"},
        {"power", at<&P::power>, within(0.1, 3), ""},
        {"spread", at<&P::spread>, within(0, 2),
         "standard deviation of the natural logarithm of measured heights about it"},
        {"open_scale", at<&P::openScale>, within(0, 500), "likewise with room on all sides (`open_grown`)",
         "m"},
        {"open_power", at<&P::openPower>, within(0.1, 3), ""},
        {"open_spread", at<&P::openSpread>, within(0, 2), ""},
        {"source", at<&P::source>, {}, "where these numbers come from"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<CrownAllometry>() {
    using P = CrownAllometry;
    static const Fields fields = {
        {"base", at<&P::base>, within(0, 50),
         "width in a forest: `base` and `per_diameter` times the diameter", "m"},
        {"per_diameter", at<&P::perDiameter>, within(0, 100), ""},
        {"open_base", at<&P::openBase>, within(0, 50), "likewise with room on all sides (`open_grown`)", "m"},
        {"open_per_diameter", at<&P::openPerDiameter>, within(0, 100), ""},
        {"spread", at<&P::spread>, within(0, 2),
         "standard deviation of the natural logarithm of measured widths about it, in a forest"},
        {"open_spread", at<&P::openSpread>, within(0, 2), "likewise with room on all sides"},
        {"depth", at<&P::depth>, within(-50, 50),
         "lowest green bough to top in a forest, of a grown tree: `depth` and `depth_per_height` times the "
         "height; both 0, or deeper than it grows: as it grows",
         "m"},
        {"depth_per_height", at<&P::depthPerHeight>, within(0, 1), ""},
    };
    return fields;
}

template <>
const Fields& fieldsOf<WoodParameters>() {
    using P = WoodParameters;
    static const Fields fields = {
        {"elastic_modulus", at<&P::elasticModulus>, within(1e3, 1e12), "of green wood", "Pa"},
        {"density", at<&P::density>, within(1, 1e4),
         R"(of green wood with its bark; this and what follows is for the law `"modal"`)", "kg/m³"},
        {"damping_ratio", at<&P::dampingRatio>, within(0, 2), "of wood, without air; 1 is critical"},
        {"under_bark", at<&P::underBark>, within(0.1, 1),
         "diameter of the wood, which alone bends, over that with its bark"},
        {"whole_stem", at<&P::wholeStem>, within(0.1, 1),
         "modulus of a living stem, with its knots and young wood, over `elastic_modulus`"},
        {"branch_modulus", at<&P::branchModulus>, within(0.01, 1),
         "modulus of branches over that of the trunk; 0.54 in built-in species"},
        {"modulus_power", at<&P::modulusPower>, within(0, 2),
         "power of the slenderness (height over diameter) that the modulus follows, from 50 to 110, 1 at 80; "
         "0.78 in built-in species"},
        {"anchorage", at<&P::anchorage>, within(0, 1e4),
         "moment that overturns the tree over the mass of its stem; 0 is rigid ground", "N m/kg"},
        {"bending_strength", at<&P::bendingStrength>, within(0, 1e9),
         "modulus of rupture of green clear wood, for moments that break a stem; 0 is not known", "Pa"},
        {"knot_factor", at<&P::knotFactor>, within(0.1, 1), "what knots leave of it in a stem"},
        {"leaf_area", at<&P::leafArea>, within(0, 1e5),
         "area of all leaves of a tree over the cross-section of its trunk at breast height; a branch bears "
         "its share of what is drawn"},
        {"leaf_mass", at<&P::leafMass>, within(0, 100), "fresh leaves over their area", "kg/m²"},
        {"wood_drag", at<&P::woodDrag>, within(0, 10), "drag coefficient of a branch"},
        {"leaf_drag", at<&P::leafDrag>, within(0, 10),
         "drag coefficient of leaves, which turn out of the wind, by their area; not used with `crown_drag`"},
        {"still_drag", at<&P::stillDrag>, within(0, 10),
         "drag coefficient of leaves that swing through still air, by their area (law `\"modal\"`); 0.75 in "
         "built-in conifers"},
        {"crown_drag", at<&P::crownDrag>, within(0, 100),
         "C of the whole crown by its outline, as measured: drag coefficient C·u^-n at u m/s; 0 is not "
         "known"},
        {"streamlining", at<&P::streamlining>, within(0, 2), "that n: drag falls with speed from 10 m/s on"},
        {"breeze_streamlining", at<&P::breezeStreamlining>, within(0, 2),
         "that n from 1.6 to 10 m/s, at the same drag at 10 m/s (law `\"modal\"`, and what one sees); 0.35 "
         "in "
         "built-in broadleaves, 0.36 in conifers"},
        {"streamlined_to", at<&P::streamlinedTo>, within(10, 200),
         "the highest speed of that measurement; C·u^-n stays as it is beyond", "m/s"},
        {"branch_wood",
         at<&P::branchWood>,
         {},
         "how much wood is in branches: as drawn, or by diameter and height as in softwoods (BAAD), or by "
         "diameter as in hardwoods (Jenkins et al. 2003)",
         "",
         inOrder({"drawn", "conifer", "broadleaf"})},
    };
    return fields;
}

template <>
const Fields& fieldsOf<BranchParameters>() {
    using P = BranchParameters;
    static const Fields fields = {
        {"max_angle", at<&P::maxAngle>, within(0, 90), "largest turn about either axis", "degrees"},
        {"partial_steps", at<&P::partialSteps>, within(1, 10000),
         "steps in which `thesis-smooth` reaches an angle"},
        {"level_factor", at<&P::levelFactor>, within(-100, 100), "added to the load per branch level", "m/s"},
        {"noise_frequency", at<&P::noiseFrequency>, within(0, 100), "of the load's noise", "Hz"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<LeafMotion>() {
    using P = LeafMotion;
    static const Fields fields = {
        {"max_angle_x", at<&P::maxAngleX>, within(0, 90), "largest swing along the branch", "degrees"},
        {"max_angle_z", at<&P::maxAngleZ>, within(0, 90), "largest swing across it", "degrees"},
        {"max_rotation", at<&P::maxRotation>, within(0, 180), "largest turn about the petiole", "degrees"},
        {"partial_steps", at<&P::partialSteps>, within(1, 10000), "steps in which a leaf reaches its angle"},
        {"factor", at<&P::factor>, within(0, 1), "how much of the largest angles is used"},
        {"linked_factor", at<&P::linkedFactor>, within(-10, 10), "rotation that goes with the swing"},
        {"noise_frequency", at<&P::noiseFrequency>, within(0, 100), "of the flutter", "Hz"},
        {"size", at<&P::size>, within(0, 10), "of a single leaf or leaflet across (law `\"modal\"`)", "m"},
        {"tremble", at<&P::tremble>, within(0, 100),
         "factor on how far single leaves move in a breeze; 1: at the speed of measured leaves of their size "
         "(law `\"modal\"`)"},
        {"max_downwind", at<&P::maxDownwind>, within(0, 60),
         "turn downwind of a petiole that stands across the wind, in the strongest, half of its tangent at "
         "10 m/s; 12 in built-in conifers, 50 in broadleaves (law `\"modal\"`)",
         "degrees"},
        {"shoot_sway", at<&P::shootSway>, within(0, 10),
         "factor on how far the thin ends of boughs sway by themselves (law `\"modal\"`)"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<Appearance>() {
    using P = Appearance;
    static const Fields fields = {
        {"bark", at<&P::bark>, within(0, 1), "linear red, green, blue"},
        {"leaves", at<&P::leaves>, within(0, 1), "linear red, green, blue"},
        {"spring_leaves", at<&P::springLeaves>, within(0, 1), "their colour as they unfold"},
        {"autumn_leaves", at<&P::autumnLeaves>, within(0, 1), "their colour before they fall"},
        {"underside", at<&P::underside>, within(1, 5),
         "brightness of the underside of leaves over that of their upper side; what is more is grey "
         "(law `\"modal\"`)"},
        {"evergreen",
         at<&P::evergreen>,
         {},
         "whether it bears its leaves all year, in the colour `leaves`; not given: as `needles`, `bundles` "
         "and `frond` do"},
        {"leaf_form",
         at<&P::leafForm>,
         {},
         "leaves on the texture",
         "",
         inOrder({"blade", "lobed", "ovate", "rhombic", "palmate", "pinnate", "heart", "round", "fingered",
                  "fan", "needles", "bundles", "tufts", "frond", "pointed"})},
        {"bark_form",
         at<&P::barkForm>,
         {},
         "surface of the bark",
         "",
         inOrder({"furrowed", "plated", "smooth", "banded", "flaking", "ringed", "scaly"})},
        {"leaf_image", at<&P::leafImage>, {}, "a picture of a spray to show instead, below", "file"},
        {"bark_image", at<&P::barkImage>, {}, "a picture of bark to show instead, below", "file"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<Species>() {
    using P = Species;
    static const Fields fields = {
        {"aliases", at<&P::aliases>, {}, "other names, as an inventory may have them; no two alike"},
        {"source", at<&P::source>, {}, "where its numbers come from"},
        {"shapes", at<&P::shapes>, within(1, mostShapes),
         "different shapes its trees share; memory grows with them"},
        {"height", at<&P::height>, {}, ""},
        {"crown", at<&P::crown>, {}, ""},
        {"wood", at<&P::wood>, {}, ""},
        {"branch", at<&P::branch>, {}, ""},
        {"leaf", at<&P::leaf>, {}, ""},
        {"appearance", at<&P::appearance>, {}, ""},
    };
    return fields;
}

} // namespace osgTreeWind
