// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/BuiltInSpecies.h>

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

/// Drag C u^-n of a crown, measured up to a speed in m/s.
struct Drag {
    float c, n, upTo;
};

/// Mean of C 10^-n and of n over birch, beech and oak.
constexpr Drag broadleafDrag{2.36f, 0.877f, 20.0f};

// Of all forms: a trunk's diameter at its top lies between a cone's and a paraboloid's.

/// A broadleaf: half its height is crown (ForestGALES: crown depths of birch, beech and oak 20 m high are
/// 0.47 to 0.51 of it), and the cross-sections of three branches make up that of the wood they spring from,
/// base to base (Leonardo's rule; Eloy 2011): taper * radiusRatio = 1 / sqrt(3).
TreeParameters broadleafForm(float inclination, float droop, float crook) {
    TreeParameters form;
    RecursiveTreeParameters& wood = form.wood;
    wood.trunkUnits = 3;
    wood.bareUnits = 2;
    wood.length = 1.7f;
    wood.boughLength = 0.3f;
    wood.taper = 0.65f;
    wood.radiusRatio = 0.888f;
    wood.radius = 0.15f;
    wood.inclination = glm::radians(inclination);
    wood.crook = crook;
    form.leaves.droop = droop;
    return form;
}

/// A conifer: whorls up a straight trunk; branches are 0.17 of the volume of its wood (Jenkins et al. 2003:
/// 0.18 at 35 cm).
TreeParameters coniferForm(int bareUnits, float bough, float crownTaper, float inclination, float droop) {
    TreeParameters form;
    RecursiveTreeParameters& wood = form.wood;
    wood.trunkUnits = 12;
    wood.bareUnits = bareUnits;
    wood.levels = 2;
    wood.childrenPerBranch = 4;
    wood.length = 1.0f;
    wood.boughLength = bough;
    wood.lengthRatio = 0.45f;
    wood.crownTaper = crownTaper;
    wood.inclination = glm::radians(inclination);
    wood.inclinationGrowth = 0.6f;
    wood.leader = 0.9f;
    wood.follow = 0.8f;
    wood.radius = 0.16f;
    wood.taper = 0.2f;
    wood.radiusRatio = 0.41f;
    wood.crook = 0.03f;
    wood.jitter = 0.12f;
    LeafParameters& leaves = form.leaves;
    leaves.length = 0.6f;
    leaves.width = 0.5f;
    leaves.innerSize = 0.9f;
    leaves.droop = droop;
    return form;
}

/// What ForestGALES knows of a species' foot and crown: overturning moment over stem mass (freely draining
/// mineral soil, roots of all depths), crown width from diameter.
struct Stand {
    float anchorage, crownBase, crownPerDiameter;
};

/// Means over birch, beech and oak.
constexpr Stand broadleafStand{178, 0.71f, 18.0f};

BuiltInSpecies entry(std::vector<std::string> names, TreeParameters form, float modulus, float density,
                     const Drag& drag, const Stand& stand, const glm::vec3& bark, const glm::vec3& leaves,
                     const char* source) {
    BuiltInSpecies built;
    built.species.name = names.front();
    built.species.tree = form;
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
    built.species.appearance.bark = bark;
    built.species.appearance.leaves = leaves;
    built.names = std::move(names);
    built.source = source;
    return built;
}

BuiltInSpecies conifer(std::vector<std::string> names, const TreeParameters& form, float modulus,
                       float density, const Drag& drag, const Stand& stand, const glm::vec3& leaves,
                       const char* source) {
    BuiltInSpecies built =
        entry(std::move(names), form, modulus, density, drag, stand, {0.16f, 0.12f, 0.10f}, leaves, source);
    Species& species = built.species;
    species.wood.leafArea = 1300.0f; // Jenkins et al. 2003: 280 kg of dry needles per m^2; 4.6 m^2 per kg
    species.wood.leafMass = 0.45f;
    species.wood.stillDrag = 0.75f; // needles as cylinders, half of it lost to each other's shelter
    species.wood.branchWood = WoodAllometry::Conifer;
    species.crown.openBase = 1.41f; // Paine and Hann 1982, Douglas fir
    species.crown.openPerDiameter = 17.0f;
    species.leaf.maxAngleX = species.leaf.maxAngleZ = glm::radians(7.0f);
    species.leaf.maxRotation = glm::radians(9.0f);
    species.appearance.leafForm = LeafForm::Needles;
    return built;
}

bool sameName(const std::string& a, const std::string& b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](char x, char y) { return lower(x) == lower(y); });
}

} // namespace

std::vector<BuiltInSpecies> builtInSpecies() {
    const TreeParameters spruce = coniferForm(4, 0.24f, 0.1f, 88.0f, 0.3f);
    const TreeParameters fir = coniferForm(4, 0.22f, 0.15f, 80.0f, 0.1f);
    TreeParameters pine = coniferForm(6, 0.22f, 0.45f, 68.0f, -0.1f);
    pine.wood.taper = 0.3f;
    pine.wood.radiusRatio = 0.48f;
    TreeParameters larch = coniferForm(5, 0.22f, 0.15f, 85.0f, 0.3f);
    larch.wood.radiusRatio = 0.5f;
    const glm::vec3 dark{0.08f, 0.15f, 0.06f}, blueGreen{0.09f, 0.17f, 0.11f}, light{0.14f, 0.22f, 0.06f};
    const glm::vec3 grey{0.19f, 0.17f, 0.15f}, brown{0.15f, 0.13f, 0.11f}, white{0.53f, 0.53f, 0.51f};
    const glm::vec3 green{0.11f, 0.20f, 0.05f}, fresh{0.15f, 0.23f, 0.06f}, deep{0.11f, 0.18f, 0.04f};
    const glm::vec3 needles{0.09f, 0.15f, 0.06f};
    return {
        conifer({"Norway spruce", "spruce", "Picea abies", "Picea"}, spruce, 6.3e9f, 850, {2.35f, 0.51f, 25},
                {129, 0.58f, 11.5f}, dark, forestGales),
        conifer({"Sitka spruce", "Picea sitchensis"}, spruce, 5.9e9f, 850, {2.35f, 0.51f, 25},
                {156, 0.64f, 13.5f}, blueGreen, forestGales),
        conifer({"Douglas fir", "Douglas-fir", "Pseudotsuga menziesii", "Pseudotsuga"}, fir, 8.3e9f, 850,
                {2.4f, 0.7f, 25}, {149, 1.83f, 10.9f}, dark, forestGales),
        conifer({"grand fir", "fir", "Abies grandis", "Abies"}, fir, 5.7e9f, 850, {4.7f, 0.74f, 25},
                {174, 2.16f, 7.7f}, dark, forestGales),
        conifer({"western hemlock", "hemlock", "Tsuga heterophylla", "Tsuga"}, spruce, 8.9e9f, 850,
                {1.51f, 0.68f, 25}, {153, 1.29f, 11.7f}, dark, forestGales),
        conifer({"Scots pine", "pine", "Pinus sylvestris", "Pinus"}, pine, 7.3e9f, 850, {3.07f, 0.75f, 25},
                {143, 0.70f, 12.0f}, needles, forestGales),
        conifer({"lodgepole pine", "Pinus contorta"}, pine, 6.4e9f, 850, {2.48f, 0.63f, 25},
                {144, 0.59f, 10.7f}, needles, forestGales),
        conifer({"Corsican pine", "black pine", "Pinus nigra"}, pine, 7.0e9f, 850, {2.57f, 0.61f, 25},
                {113, 0.68f, 12.5f}, needles, forestGales),
        conifer({"radiata pine", "Monterey pine", "Pinus radiata"}, pine, 6.8e9f, 1002, {2.35f, 0.51f, 25},
                {86, 2.96f, 6.4f}, needles, forestGales),
        conifer({"white spruce", "Picea glauca"}, spruce, 1.0e10f, 850, {2.35f, 0.51f, 20},
                {207, 0.77f, 12.0f}, dark, forestGales),
        conifer({"balsam fir", "Abies balsamea"}, fir, 7.8e9f, 616, {2.4f, 0.7f, 20}, {189, 0.88f, 11.0f},
                dark, forestGales),
        conifer({"European larch", "larch", "Larix decidua", "Larix"}, larch, 7.9e9f, 850, {3.07f, 0.75f, 25},
                {149, 0.60f, 15.2f}, light, forestGales),
        entry({"silver birch", "birch", "Betula pendula", "Betula pubescens", "Betula"},
              broadleafForm(32, 0.7f, 0.05f), 9.9e9f, 900, {1.963f, 0.881f, 20}, {131, 0.88f, 17.0f}, white,
              fresh, forestGales),
        entry({"beech", "European beech", "Fagus sylvatica", "Fagus"}, broadleafForm(38, 0.2f, 0.05f), 9.8e9f,
              1158, {2.414f, 0.904f, 20}, {202, 0.88f, 18.0f}, grey, deep, forestGales),
        entry({"oak", "English oak", "pedunculate oak", "sessile oak", "Quercus robur", "Quercus petraea",
               "Quercus"},
              broadleafForm(50, 0.3f, 0.09f), 8.3e9f, 1158, {2.658f, 0.846f, 20}, {202, 0.36f, 19.0f}, brown,
              green, forestGales),
        entry({"ash", "European ash", "Fraxinus excelsior", "Fraxinus"}, broadleafForm(38, 0.4f, 0.05f),
              9.5e9f, 800, broadleafDrag, broadleafStand, grey, green, lavers),
        entry({"sycamore", "sycamore maple", "Acer pseudoplatanus", "Acer"}, broadleafForm(42, 0.3f, 0.05f),
              8.4e9f, 830, broadleafDrag, broadleafStand, grey, deep, lavers),
        entry({"red maple", "Acer rubrum"}, broadleafForm(40, 0.3f, 0.05f), 9.6e9f, 830, broadleafDrag,
              broadleafStand, grey, green, woodHandbook),
        entry({"red oak", "northern red oak", "Quercus rubra"}, broadleafForm(46, 0.3f, 0.07f), 9.3e9f, 980,
              broadleafDrag, broadleafStand, brown, green, woodHandbook),
        entry({"aspen", "quaking aspen", "Populus tremuloides", "Populus tremula"},
              broadleafForm(30, 0.3f, 0.04f), 5.9e9f, 730, broadleafDrag, broadleafStand, white, fresh,
              woodHandbook),
        entry({"linden", "lime", "basswood", "Tilia americana", "Tilia cordata", "Tilia"},
              broadleafForm(38, 0.4f, 0.05f), 7.2e9f, 660, broadleafDrag, broadleafStand, brown, fresh,
              woodHandbook),
        conifer({"conifer"}, spruce, 7.1e9f, 850, {2.6f, 0.63f, 25}, {144, 0.9f, 11.5f}, dark,
                "near the means of the conifers of ForestGALES above"),
        entry({"broadleaf"}, broadleafForm(42, 0.3f, 0.05f), 9.0e9f, 900, broadleafDrag, broadleafStand, grey,
              green, "means of green hardwoods, Forest Products Laboratory 2010; drag: ForestGALES"),
    };
}

std::optional<Species> findBuiltInSpecies(const std::string& name) {
    for (BuiltInSpecies& built : builtInSpecies())
        for (const std::string& own : built.names)
            if (sameName(own, name))
                return std::move(built.species);
    return {};
}

Species defaultSpecies() {
    return *findBuiltInSpecies("broadleaf");
}

} // namespace osgTreeWind
