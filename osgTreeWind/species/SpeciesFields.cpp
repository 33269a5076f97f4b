// SPDX-License-Identifier: MIT
#include <osgTreeWind/species/SpeciesFields.h>

namespace osgTreeWind {

template <>
const Fields& fieldsOf<CrownAllometry>() {
    using P = CrownAllometry;
    static const Fields fields = {
        {"base", memberOf<&P::base>, within(0, 50), "m",
         "width in a forest: `base` and `per_diameter` times the diameter"},
        {"per_diameter", memberOf<&P::perDiameter>, within(0, 100), "", ""},
        {"open_base", memberOf<&P::openBase>, within(0, 50), "m",
         "likewise with room on all sides (`open_grown`)"},
        {"open_per_diameter", memberOf<&P::openPerDiameter>, within(0, 100), "", ""},
    };
    return fields;
}

template <>
const Fields& fieldsOf<WoodParameters>() {
    using P = WoodParameters;
    static const Fields fields = {
        {"elastic_modulus", memberOf<&P::elasticModulus>, within(1e3, 1e12), "Pa", "of green wood"},
        {"density", memberOf<&P::density>, within(1, 1e4), "kg/m³",
         "of green wood with its bark; this and what follows is for the laws `\"modal\"` and `\"damped\"`"},
        {"damping_ratio", memberOf<&P::dampingRatio>, within(0, 2), "",
         "of wood, without air; 1 is critical"},
        {"under_bark", memberOf<&P::underBark>, within(0.1, 1), "",
         "diameter of the wood, which alone bends, over that with its bark"},
        {"whole_stem", memberOf<&P::wholeStem>, within(0.1, 1), "",
         "modulus of a living stem, with its knots and young wood, over `elastic_modulus`; 0.85 in built-in "
         "species"},
        {"branch_modulus", memberOf<&P::branchModulus>, within(0.01, 1), "",
         "modulus of branches over that of the trunk; 0.54 in built-in species"},
        {"modulus_power", memberOf<&P::modulusPower>, within(0, 2), "",
         "power of the slenderness (height over diameter) that the modulus follows, from 50 to 110, 1 at 80; "
         "0.78 in built-in species"},
        {"anchorage", memberOf<&P::anchorage>, within(0, 1e4), "N m/kg",
         "moment that overturns the tree over the mass of its stem; 0 is rigid ground"},
        {"leaf_area", memberOf<&P::leafArea>, within(0, 1e5), "",
         "area of all leaves of a tree over the cross-section of its trunk at breast height; a branch bears "
         "its share of what is drawn"},
        {"leaf_mass", memberOf<&P::leafMass>, within(0, 100), "kg/m²", "fresh leaves over their area"},
        {"wood_drag", memberOf<&P::woodDrag>, within(0, 10), "", "drag coefficient of a branch"},
        {"leaf_drag", memberOf<&P::leafDrag>, within(0, 10), "",
         "drag coefficient of leaves, which turn out of the wind, by their area; not used with `crown_drag`"},
        {"still_drag", memberOf<&P::stillDrag>, within(0, 10), "",
         "drag coefficient of leaves that swing through still air, by their area (law `\"modal\"`); 0.75 in "
         "built-in conifers"},
        {"crown_drag", memberOf<&P::crownDrag>, within(0, 100), "",
         "C of the whole crown by its outline, as measured: drag coefficient C·u^-n at u m/s; 0 is not "
         "known"},
        {"streamlining", memberOf<&P::streamlining>, within(0, 2), "",
         "that n: drag falls with speed from 10 m/s on"},
        {"streamlined_to", memberOf<&P::streamlinedTo>, within(10, 200), "m/s",
         "the highest speed of that measurement; C·u^-n stays as it is beyond"},
        {"branch_wood",
         memberOf<&P::branchWood>,
         {},
         "",
         "how much wood is in branches: as drawn, or by the diameter of the trunk as in softwoods or in "
         "hardwoods (Jenkins et al. 2003)",
         inOrder({"drawn", "conifer", "broadleaf"})},
    };
    return fields;
}

template <>
const Fields& fieldsOf<BranchParameters>() {
    using P = BranchParameters;
    static const Fields fields = {
        {"max_angle", memberOf<&P::maxAngle>, within(0, 90), "degrees", "largest turn about either axis"},
        {"partial_steps", memberOf<&P::partialSteps>, within(1, 10000), "",
         "steps in which `thesis-smooth` reaches an angle"},
        {"level_factor", memberOf<&P::levelFactor>, within(-100, 100), "m/s",
         "added to the load per branch level"},
        {"noise_frequency", memberOf<&P::noiseFrequency>, within(0, 100), "Hz", "of the load's noise"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<LeafMotion>() {
    using P = LeafMotion;
    static const Fields fields = {
        {"max_angle_x", memberOf<&P::maxAngleX>, within(0, 90), "degrees", "largest swing along the branch"},
        {"max_angle_z", memberOf<&P::maxAngleZ>, within(0, 90), "degrees", "largest swing across it"},
        {"max_rotation", memberOf<&P::maxRotation>, within(0, 180), "degrees",
         "largest turn about the petiole"},
        {"partial_steps", memberOf<&P::partialSteps>, within(1, 10000), "",
         "steps in which a leaf reaches its angle"},
        {"factor", memberOf<&P::factor>, within(0, 1), "", "how much of the largest angles is used"},
        {"linked_factor", memberOf<&P::linkedFactor>, within(-10, 10), "",
         "rotation that goes with the swing"},
        {"noise_frequency", memberOf<&P::noiseFrequency>, within(0, 100), "Hz", "of the flutter"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<Appearance>() {
    using P = Appearance;
    static const Fields fields = {
        {"bark", memberOf<&P::bark>, within(0, 1), "", "linear red, green, blue"},
        {"leaves", memberOf<&P::leaves>, within(0, 1), "", "linear red, green, blue"},
        {"spring_leaves", memberOf<&P::springLeaves>, within(0, 1), "", "their colour as they unfold"},
        {"autumn_leaves", memberOf<&P::autumnLeaves>, within(0, 1), "", "their colour before they fall"},
        {"evergreen",
         memberOf<&P::evergreen>,
         {},
         "",
         "whether it bears its leaves all year, in the colour `leaves`; not given: as `needles`, `bundles` "
         "and `frond` do"},
        {"leaf_form",
         memberOf<&P::leafForm>,
         {},
         "",
         "leaves on the texture",
         inOrder({"blade", "lobed", "ovate", "rhombic", "palmate", "pinnate", "heart", "round", "fingered",
                  "fan", "needles", "bundles", "tufts", "frond"})},
        {"bark_form",
         memberOf<&P::barkForm>,
         {},
         "",
         "surface of the bark",
         inOrder({"furrowed", "plated", "smooth", "banded", "flaking", "ringed"})},
        {"leaf_image", memberOf<&P::leafImage>, {}, "file", "a picture of a spray to show instead, below"},
        {"bark_image", memberOf<&P::barkImage>, {}, "file", "a picture of bark to show instead, below"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<Species>() {
    using P = Species;
    static const Fields fields = {
        {"aliases",
         memberOf<&P::aliases>,
         {},
         "",
         "other names, as an inventory may have them; no two alike"},
        {"source", memberOf<&P::source>, {}, "", "where its numbers come from"},
        {"shapes", memberOf<&P::shapes>, within(1, mostShapes), "",
         "different shapes its trees share; memory grows with them"},
        {"crown", memberOf<&P::crown>, {}, "", ""},
        {"wood", memberOf<&P::wood>, {}, "", ""},
        {"branch", memberOf<&P::branch>, {}, "", ""},
        {"leaf", memberOf<&P::leaf>, {}, "", ""},
        {"appearance", memberOf<&P::appearance>, {}, "", ""},
    };
    return fields;
}

} // namespace osgTreeWind
