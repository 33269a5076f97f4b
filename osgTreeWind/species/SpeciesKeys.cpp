// SPDX-License-Identifier: MIT
#include <osgTreeWind/species/SpeciesKeys.h>

namespace osgTreeWind {

template <>
const Keys& keysOf<HeightAllometry>() {
    using P = HeightAllometry;
    static const Keys keys = {
        {"scale", at<&P::scale>, within(0, 500), "Factor of the height law", "m"},
        {"power", at<&P::power>, within(0.1, 3), "Exponent of the height law"},
        {"spread", at<&P::spread>, within(0, 2), "Standard deviation of ln(height)"},
        {"open_scale", at<&P::openScale>, within(0, 500), "`scale` of open-grown trees", "m"},
        {"open_power", at<&P::openPower>, within(0.1, 3), "`power` of open-grown trees"},
        {"open_spread", at<&P::openSpread>, within(0, 2), "`spread` of open-grown trees"},
        {"diameter", at<&P::diameter>, within(0.01, 2), "Median of the trunk diameters in forests", "m"},
        {"diameter_spread", at<&P::diameterSpread>, within(0.01, 2), "Standard deviation of ln(diameter)"},
        {"open_diameter", at<&P::openDiameter>, within(0.01, 2), "`diameter` of open-grown trees", "m"},
        {"open_diameter_spread", at<&P::openDiameterSpread>, within(0.01, 2),
         "`diameter_spread` of open-grown trees"},
        {"largest", at<&P::largest>, within(0, 150),
         "Height of the tallest tree on record, at which estimates end; inventories may have heights up to "
         "1.5 times as large. 0: unknown",
         "m"},
        {"source", at<&P::source>, {}, "Source of these numbers"},
    };
    return keys;
}

template <>
const Keys& keysOf<CrownAllometry>() {
    using P = CrownAllometry;
    static const Keys keys = {
        {"base", at<&P::base>, within(0, 50), "Constant of the width law", "m"},
        {"per_diameter", at<&P::perDiameter>, within(0, 100), "Slope of the width law"},
        {"open_base", at<&P::openBase>, within(0, 50), "`base` of open-grown trees", "m"},
        {"open_per_diameter", at<&P::openPerDiameter>, within(0, 100), "`per_diameter` of open-grown trees"},
        {"spread", at<&P::spread>, within(0, 2), "Standard deviation of ln(width)"},
        {"open_spread", at<&P::openSpread>, within(0, 2), "`spread` of open-grown trees"},
        {"depth", at<&P::depth>, within(-50, 50), "Constant of the depth law", "m"},
        {"depth_per_height", at<&P::depthPerHeight>, within(0, 1), "Slope of the depth law"},
        {"largest", at<&P::largest>, within(0, 100),
         "The same as `species.height.largest` for the crown's width", "m"},
    };
    return keys;
}

template <>
const Keys& keysOf<WoodParameters>() {
    using P = WoodParameters;
    static const Keys keys = {
        {"elastic_modulus", at<&P::elasticModulus>, within(1e3, 1e12), "Elastic modulus of green wood", "Pa"},
        {"density", at<&P::density>, within(1, 1e4), "Density of green wood with bark", "kg/m³"},
        {"damping_ratio", at<&P::dampingRatio>, within(0, 2), "Damping ratio of the wood, without air"},
        {"under_bark", at<&P::underBark>, within(0.1, 1), "Ratio of diameter without bark to that with bark"},
        {"whole_stem", at<&P::wholeStem>, within(0.1, 1),
         "Modulus of a living stem with knots / `elastic_modulus`"},
        {"branch_modulus", at<&P::branchModulus>, within(0.01, 1),
         "Ratio of the branch modulus to the trunk modulus"},
        {"modulus_power", at<&P::modulusPower>, within(0, 2),
         "Power of the [slenderness](validation.md#properties-of-built-in-species) to which the modulus is "
         "proportional"},
        {"anchorage", at<&P::anchorage>, within(0, 1e4), "Overturning moment / stem mass; 0: rigid ground",
         "N m/kg"},
        {"bending_strength", at<&P::bendingStrength>, within(0, 1e9),
         "Modulus of rupture of clear green wood; 0 if unknown", "Pa"},
        {"knot_factor", at<&P::knotFactor>, within(0.1, 1), "Share of `bending_strength` left by knots"},
        {"leaf_area", at<&P::leafArea>, within(0, 1e5), "Leaf area / trunk cross-section at breast height"},
        {"leaf_mass", at<&P::leafMass>, within(0, 100), "Mass of fresh leaves per leaf area", "kg/m²"},
        {"wood_drag", at<&P::woodDrag>, within(0, 10), "Drag coefficient of a branch"},
        {"leaf_drag", at<&P::leafDrag>, within(0, 10),
         "Drag coefficient of leaves, referred to leaf area; not used with `crown_drag`"},
        {"still_drag", at<&P::stillDrag>, within(0, 10),
         "Drag coefficient of leaves that swing in still air, referred to leaf area"},
        {"crown_drag", at<&P::crownDrag>, within(0, 100),
         "Factor C of the measured drag coefficient C·u^-n at u m/s, referred to the crown's outline; 0 if "
         "unknown"},
        {"streamlining", at<&P::streamlining>, within(0, 2), "Exponent n above 10 m/s"},
        {"breeze_streamlining", at<&P::breezeStreamlining>, within(0, 2), "Exponent n from 1.6 to 10 m/s"},
        {"streamlined_to", at<&P::streamlinedTo>, within(10, 200),
         "Highest measured speed; C·u^-n is constant above it", "m/s"},
        {"branch_wood",
         at<&P::branchWood>,
         {},
         "Source of branch mass: the drawn branches, softwoods (BAAD), or hardwoods (BAAD, Jenkins et al. "
         "2003)",
         "",
         numberedFromZero({"drawn", "conifer", "broadleaf"})},
    };
    return keys;
}

template <>
const Keys& keysOf<BranchParameters>() {
    using P = BranchParameters;
    static const Keys keys = {
        {"max_angle", at<&P::maxAngle>, within(0, 90), "Largest rotation about each axis", "degrees"},
        {"partial_steps", at<&P::partialSteps>, within(1, 10000),
         "Number of steps to a new angle (`thesis-smooth`)"},
        {"level_factor", at<&P::levelFactor>, within(-100, 100),
         "Load added per branch level (`thesis-smooth`)", "m/s"},
        {"noise_frequency", at<&P::noiseFrequency>, within(0, 100), "Frequency of the load's noise", "Hz"},
    };
    return keys;
}

template <>
const Keys& keysOf<LeafMotion>() {
    using P = LeafMotion;
    static const Keys keys = {
        {"max_angle_x", at<&P::maxAngleX>, within(0, 90), "Largest swing along the branch", "degrees"},
        {"max_angle_z", at<&P::maxAngleZ>, within(0, 90), "Largest swing across the branch", "degrees"},
        {"max_rotation", at<&P::maxRotation>, within(0, 180), "Largest rotation about the petiole",
         "degrees"},
        {"partial_steps", at<&P::partialSteps>, within(1, 10000), "Number of steps to a new angle"},
        {"factor", at<&P::factor>, within(0, 1), "Factor on the largest swings"},
        {"linked_factor", at<&P::linkedFactor>, within(-10, 10),
         "Rotation about the petiole / swing along the branch"},
        {"noise_frequency", at<&P::noiseFrequency>, within(0, 100), "Frequency of the flutter", "Hz"},
        {"size", at<&P::size>, within(0, 10), "Width of a leaf or leaflet (`modal`)", "m"},
        {"tremble", at<&P::tremble>, within(0, 100),
         "Factor on the trembling of single leaves; 1 is as measured (`modal`)"},
        {"max_downwind", at<&P::maxDownwind>, within(0, 60),
         "Largest downwind turn of a petiole that stands across the wind (`modal`)", "degrees"},
        {"shoot_sway", at<&P::shootSway>, within(0, 10), "Factor on the sway of thin bough ends (`modal`)"},
    };
    return keys;
}

template <>
const Keys& keysOf<Appearance>() {
    using P = Appearance;
    static const Keys keys = {
        {"bark", at<&P::bark>, within(0, 1), "Bark colour"},
        {"old_bark", at<&P::oldBark>, within(0, 1),
         "Colour of the thick bark at the foot of old stems; by default `bark`, and nearly black for "
         "`banded`"},
        {"leaves", at<&P::leaves>, within(0, 1), "Leaf colour in summer"},
        {"spring_leaves", at<&P::springLeaves>, within(0, 1),
         "Colour of unfolding leaves, and of the shoots of this year on evergreens"},
        {"autumn_leaves", at<&P::autumnLeaves>, within(0, 1), "Leaf colour before the leaves fall"},
        {"underside", at<&P::underside>, within(1, 5),
         "Ratio of underside to upper-side brightness of leaves (`modal`)"},
        {"evergreen",
         at<&P::evergreen>,
         {},
         "Whether leaves stay all year; by default true for `needles`, `bundles` and `frond`"},
        {"leaf_form",
         at<&P::leafForm>,
         {},
         "Shape of the leaves",
         "",
         numberedFromZero({"blade", "lobed", "ovate", "rhombic", "palmate", "pinnate", "heart", "round",
                           "fingered", "fan", "needles", "bundles", "tufts", "frond", "pointed", "combed"})},
        {"bark_form",
         at<&P::barkForm>,
         {},
         "Surface of the bark",
         "",
         numberedFromZero({"furrowed", "plated", "smooth", "banded", "flaking", "ringed", "scaly"})},
        {"leaf_image", at<&P::leafImage>, {}, "Image of a spray, instead of `leaf_form`", "file"},
        {"bark_image", at<&P::barkImage>, {}, "Image of bark, instead of `bark_form`", "file"},
    };
    return keys;
}

template <>
const Keys& keysOf<Species>() {
    using P = Species;
    static const Keys keys = {
        {"aliases", at<&P::aliases>, {}, "Other names; each must be unique"},
        {"source", at<&P::source>, {}, "Source of the numbers"},
        {"shapes", at<&P::shapes>, within(1, maxShapes), "Number of different shapes that the trees share"},
        {"height", at<&P::height>, {}, ""},
        {"crown", at<&P::crown>, {}, ""},
        {"wood", at<&P::wood>, {}, ""},
        {"branch", at<&P::branch>, {}, ""},
        {"leaf", at<&P::leaf>, {}, ""},
        {"appearance", at<&P::appearance>, {}, ""},
    };
    return keys;
}

} // namespace osgTreeWind
