// SPDX-License-Identifier: MIT
#include <osgTreeWind/species/BuiltInSpecies.h>

#include <osgTreeWind/species/LeafCoverage.h>
#include <osgTreeWind/species/SpeciesForms.h>

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr const char* forestGales =
    "ForestGALES species table (Gardiner et al. 2000; parameters as in fgr): green modulus, density, C, n";
constexpr const char* lavers =
    "Lavers 1983, green modulus; Forest Products Laboratory 2010, green density of the American relative; "
    "drag: mean of the broadleaves of ForestGALES";
constexpr const char* woodHandbook =
    "Forest Products Laboratory 2010 (Wood Handbook, tables 5-3 and 4-1), green modulus and density; drag: "
    "mean of the broadleaves of ForestGALES";

constexpr const char* woodHandbookKin =
    "Forest Products Laboratory 2010, green modulus and density of the nearest kin (cottonwood, American "
    "sycamore, red and sugar maple, yellow buckeye, eastern white pine); drag: mean of the broadleaves of "
    "ForestGALES";

/// Drag C u^-n of a crown, measured up to a speed in m/s.
struct Drag {
    float c, n, upTo;
};

/// Mean of C 10^-n and of n over birch, beech and oak.
constexpr Drag broadleafDrag{2.36f, 0.877f, 20.0f};

/// What ForestGALES knows of a species' foot and crown: overturning moment over stem mass (freely draining
/// mineral soil, roots of all depths), crown width from diameter.
struct Stand {
    float anchorage, crownBase, crownPerDiameter;
};

/// Means over birch, beech and oak.
constexpr Stand broadleafStand{178, 0.71f, 18.0f};

/// Linear colours.
struct Look {
    BarkForm barkForm;
    glm::vec3 bark;
    LeafForm leafForm;
    glm::vec3 leaves;
    glm::vec3 autumn = Appearance().autumnLeaves;
};

BuiltInSpecies entry(std::vector<std::string> names, SpeciesForm form, float modulus, float density,
                     const Drag& drag, const Stand& stand, const Look& look, const char* source) {
    BuiltInSpecies built;
    built.species.name = names.front();
    built.species.tree = speciesForm(form);
    built.species.wood.elasticModulus = modulus;
    built.species.wood.density = density;
    built.species.wood.underBark = 0.93f; // Miles and Smith 2009: bark is some 15 % of the volume of the wood
    built.species.wood.wholeStem = 0.85f; // Cannell and Morgan 1987, Milne and Blackburn 1989
    built.species.wood.branchModulus = 0.54f; // Cannell and Morgan 1987
    built.species.wood.modulusPower = 0.78f;  // Waghorn and Watt 2013
    built.species.wood.anchorage = stand.anchorage;
    built.species.wood.branchWood = WoodAllometry::Broadleaf;
    // In the open: Krajicek et al. 1961, oaks and hickories.
    built.species.crown = {stand.crownBase, stand.crownPerDiameter, 0.95f, 21.9f};
    built.species.wood.crownDrag = drag.c;
    built.species.wood.streamlining = drag.n;
    built.species.wood.streamlinedTo = drag.upTo;
    built.species.appearance.bark = look.bark;
    built.species.appearance.barkForm = look.barkForm;
    built.species.appearance.leaves = look.leaves;
    built.species.appearance.springLeaves = 1.35f * look.leaves + glm::vec3(0.02f, 0.03f, 0.0f);
    built.species.appearance.autumnLeaves = look.autumn;
    built.species.appearance.leafForm = look.leafForm;
    built.names = std::move(names);
    built.source = source;
    return built;
}

BuiltInSpecies conifer(std::vector<std::string> names, SpeciesForm form, float modulus, float density,
                       const Drag& drag, const Stand& stand, const Look& look, const char* source) {
    BuiltInSpecies built = entry(std::move(names), form, modulus, density, drag, stand, look, source);
    Species& species = built.species;
    species.wood.leafArea = 1300.0f; // Jenkins et al. 2003: 280 kg of dry needles per m^2; 4.6 m^2 per kg
    species.wood.leafMass = 0.45f;
    species.wood.stillDrag = 0.75f; // needles as cylinders, half of it lost to each other's shelter
    species.wood.branchWood = WoodAllometry::Conifer;
    species.crown.openBase = 1.41f; // Paine and Hann 1982, Douglas fir
    species.crown.openPerDiameter = 17.0f;
    species.leaf.maxAngleX = species.leaf.maxAngleZ = glm::radians(7.0f);
    species.leaf.maxRotation = glm::radians(9.0f);
    return built;
}

/// No branches but fronds, no crown that grows wider.
BuiltInSpecies palm(std::vector<std::string> names, const Look& look, const char* source) {
    BuiltInSpecies built =
        entry(std::move(names), SpeciesForm::Palm, 5.0e9f, 900, {0, 0, 25}, broadleafStand, look, source);
    Species& species = built.species;
    species.wood.underBark = species.wood.wholeStem = species.wood.branchModulus = 1.0f;
    species.wood.modulusPower = 0.0f;
    species.wood.branchWood = WoodAllometry::Drawn;
    species.wood.leafArea = 750.0f; // some 50 fronds of 1.5 m^2 on a stem of 35 cm
    species.wood.leafMass = 0.4f;
    species.crown = {};
    return built;
}

bool sameName(const std::string& a, const std::string& b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](char x, char y) { return lower(x) == lower(y); });
}

} // namespace

std::vector<BuiltInSpecies> builtInSpecies() {
    using F = SpeciesForm;
    using B = BarkForm;
    using L = LeafForm;
    const glm::vec3 dark{0.08f, 0.15f, 0.06f}, blueGreen{0.09f, 0.17f, 0.11f}, light{0.14f, 0.22f, 0.06f};
    const glm::vec3 grey{0.19f, 0.17f, 0.15f}, brown{0.15f, 0.13f, 0.11f}, white{0.53f, 0.53f, 0.51f};
    const glm::vec3 green{0.115f, 0.19f, 0.055f}, fresh{0.15f, 0.23f, 0.06f}, deep{0.11f, 0.172f, 0.045f};
    const glm::vec3 needles{0.09f, 0.15f, 0.06f}, yellowish{0.16f, 0.23f, 0.05f};
    const glm::vec3 resin{0.16f, 0.12f, 0.10f}, orange{0.22f, 0.12f, 0.07f}, pale{0.28f, 0.28f, 0.24f};
    const glm::vec3 golden{0.50f, 0.32f, 0.03f}, straw{0.38f, 0.27f, 0.05f}, copper{0.36f, 0.15f, 0.03f};
    const glm::vec3 red{0.36f, 0.07f, 0.02f};
    const Look spruce{B::Plated, resin, L::Needles, dark}, fir{B::Smooth, grey, L::Needles, dark};
    const Look pine{B::Plated, brown, L::Bundles, needles};
    std::vector<BuiltInSpecies> all = {
        conifer({"Norway spruce", "spruce", "Picea abies", "Picea"}, F::Spruce, 6.3e9f, 850,
                {2.35f, 0.51f, 25}, {129, 0.58f, 11.5f}, spruce, forestGales),
        conifer({"Sitka spruce", "Picea sitchensis"}, F::SitkaSpruce, 5.9e9f, 850, {2.35f, 0.51f, 25},
                {156, 0.64f, 13.5f}, {B::Plated, resin, L::Needles, blueGreen}, forestGales),
        conifer({"Douglas fir", "Douglas-fir", "Pseudotsuga menziesii", "Pseudotsuga"}, F::DouglasFir, 8.3e9f,
                850, {2.4f, 0.7f, 25}, {149, 1.83f, 10.9f}, {B::Furrowed, resin, L::Needles, dark},
                forestGales),
        conifer({"grand fir", "fir", "Abies grandis", "Abies"}, F::Fir, 5.7e9f, 850, {4.7f, 0.74f, 25},
                {174, 2.16f, 7.7f}, fir, forestGales),
        conifer({"western hemlock", "hemlock", "Tsuga heterophylla", "Tsuga"}, F::Hemlock, 8.9e9f, 850,
                {1.51f, 0.68f, 25}, {153, 1.29f, 11.7f}, {B::Furrowed, resin, L::Needles, dark}, forestGales),
        conifer({"Scots pine", "pine", "Pinus sylvestris", "Pinus"}, F::ScotsPine, 7.3e9f, 850,
                {3.07f, 0.75f, 25}, {143, 0.70f, 12.0f}, {B::Plated, orange, L::Bundles, blueGreen},
                forestGales),
        conifer({"lodgepole pine", "Pinus contorta"}, F::LodgepolePine, 6.4e9f, 850, {2.48f, 0.63f, 25},
                {144, 0.59f, 10.7f}, pine, forestGales),
        conifer({"Corsican pine", "black pine", "Austrian pine", "Pinus nigra", "Pinus ponderosa"},
                F::CorsicanPine, 7.0e9f, 850, {2.57f, 0.61f, 25}, {113, 0.68f, 12.5f},
                {B::Plated, grey, L::Bundles, dark}, forestGales),
        conifer({"radiata pine", "Monterey pine", "Pinus radiata"}, F::RadiataPine, 6.8e9f, 1002,
                {2.35f, 0.51f, 25}, {86, 2.96f, 6.4f}, pine, forestGales),
        conifer({"white spruce", "Picea glauca", "blue spruce", "Picea pungens"}, F::WhiteSpruce, 1.0e10f,
                850, {2.35f, 0.51f, 20}, {207, 0.77f, 12.0f}, {B::Plated, grey, L::Needles, blueGreen},
                forestGales),
        conifer({"balsam fir", "Abies balsamea"}, F::BalsamFir, 7.8e9f, 616, {2.4f, 0.7f, 20},
                {189, 0.88f, 11.0f}, fir, forestGales),
        conifer({"European larch", "larch", "Larix decidua", "Larix"}, F::Larch, 7.9e9f, 850,
                {3.07f, 0.75f, 25}, {149, 0.60f, 15.2f}, {B::Plated, resin, L::Tufts, light, golden},
                forestGales),
        entry({"silver birch", "birch", "Betula pendula", "Betula pubescens", "Betula"}, F::Birch, 9.9e9f,
              900, {1.963f, 0.881f, 20}, {131, 0.88f, 17.0f}, {B::Banded, white, L::Rhombic, fresh, golden},
              forestGales),
        entry({"beech", "European beech", "Fagus sylvatica", "Fagus"}, F::Beech, 9.8e9f, 1158,
              {2.414f, 0.904f, 20}, {202, 0.88f, 18.0f}, {B::Smooth, grey, L::Ovate, deep, copper},
              forestGales),
        entry({"oak", "English oak", "pedunculate oak", "sessile oak", "Quercus robur", "Quercus petraea",
               "Quercus"},
              F::Oak, 8.3e9f, 1158, {2.658f, 0.846f, 20}, {202, 0.36f, 19.0f},
              {B::Furrowed, brown, L::Lobed, green}, forestGales),
        entry({"ash", "European ash", "Fraxinus excelsior", "Fraxinus"}, F::Ash, 9.5e9f, 800, broadleafDrag,
              broadleafStand, {B::Furrowed, grey, L::Pinnate, green, straw}, lavers),
        entry({"sycamore", "sycamore maple", "Acer pseudoplatanus", "Acer"}, F::Sycamore, 8.4e9f, 830,
              broadleafDrag, broadleafStand, {B::Smooth, grey, L::Palmate, deep, straw}, lavers),
        entry({"red maple", "Acer rubrum", "silver maple", "Acer saccharinum"}, F::RedMaple, 9.6e9f, 830,
              broadleafDrag, broadleafStand, {B::Furrowed, grey, L::Palmate, green, red}, woodHandbook),
        entry({"red oak", "northern red oak", "Quercus rubra"}, F::RedOak, 9.3e9f, 980, broadleafDrag,
              broadleafStand, {B::Furrowed, brown, L::Lobed, green, red}, woodHandbook),
        entry({"aspen", "quaking aspen", "Populus tremuloides", "Populus tremula", "Populus"}, F::Aspen,
              5.9e9f, 730, broadleafDrag, broadleafStand, {B::Smooth, pale, L::Round, fresh, golden},
              woodHandbook),
        entry({"linden", "lime", "basswood", "Tilia americana", "Tilia cordata", "Tilia"}, F::Lime, 7.2e9f,
              660, broadleafDrag, broadleafStand, {B::Furrowed, brown, L::Heart, fresh, golden},
              woodHandbook),
        entry({"poplar", "Lombardy poplar", "black poplar", "Populus nigra"}, F::Poplar, 7.0e9f, 940,
              broadleafDrag, broadleafStand, {B::Furrowed, grey, L::Round, green, golden}, woodHandbookKin),
        entry({"London plane", "plane", "Platanus x acerifolia", "Platanus x hispanica", "Platanus"},
              F::Plane, 7.3e9f, 1020, broadleafDrag, broadleafStand,
              {B::Flaking, pale, L::Palmate, green, straw}, woodHandbookKin),
        entry({"honey locust", "Gleditsia triacanthos", "Gleditsia", "Robinia", "Gymnocladus"},
              F::HoneyLocust, 8.9e9f, 980, broadleafDrag, broadleafStand,
              {B::Furrowed, brown, L::Pinnate, yellowish, golden}, woodHandbook),
        entry({"Norway maple", "Acer platanoides"}, F::NorwayMaple, 10.1e9f, 890, broadleafDrag,
              broadleafStand, {B::Furrowed, grey, L::Palmate, deep, golden}, woodHandbookKin),
        entry({"horse chestnut", "horse-chestnut", "Aesculus hippocastanum", "Aesculus"}, F::HorseChestnut,
              6.8e9f, 800, broadleafDrag, broadleafStand, {B::Plated, brown, L::Fingered, deep},
              woodHandbookKin),
        entry({"ginkgo", "Ginkgo biloba"}, F::Ginkgo, 6.8e9f, 800, broadleafDrag, broadleafStand,
              {B::Furrowed, grey, L::Fan, yellowish, golden}, woodHandbookKin),
        palm({"palm", "Mexican fan palm", "Washingtonia robusta", "Washingtonia", "Phoenix", "Arecaceae"},
             {B::Ringed, {0.16f, 0.14f, 0.12f}, L::Frond, green},
             "our estimate within Rich 1987 (stems of palms: 0.1 to 20 GPa); drag by leaf area"),
        conifer({"conifer", "Cedrus", "Juniperus"}, F::Conifer, 7.1e9f, 850, {2.6f, 0.63f, 25},
                {144, 0.9f, 11.5f}, spruce, "near the means of the conifers of ForestGALES above"),
        entry({"broadleaf", "Ulmus", "Morus", "Zelkova", "Pyrus", "Malus", "Prunus", "Crataegus", "Cercis",
               "Carpinus", "Koelreuteria", "Magnolia", "Liriodendron", "Liquidambar", "Rhus"},
              F::Broadleaf, 9.0e9f, 900, broadleafDrag, broadleafStand, {B::Furrowed, grey, L::Blade, green},
              "means of green hardwoods, Forest Products Laboratory 2010; drag: ForestGALES"),
    };
    for (BuiltInSpecies& built : all)
        built.species.tree.leaves.area = cardArea(built.species);
    return all;
}

std::optional<Species> findBuiltInSpecies(const std::string& name) {
    const std::string genus = name.substr(0, name.find(' '));
    std::vector<BuiltInSpecies> all = builtInSpecies();
    for (const std::string& wanted : {name, genus})
        for (BuiltInSpecies& built : all)
            for (const std::string& own : built.names)
                if (sameName(own, wanted))
                    return std::move(built.species);
    return {};
}

Species defaultSpecies() {
    return *findBuiltInSpecies("broadleaf");
}

} // namespace osgTreeWind
