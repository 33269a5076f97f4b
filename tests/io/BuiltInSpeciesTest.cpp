// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>
#include <osgTreeWind/species/LeafCoverage.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

using namespace osgTreeWind;

namespace {

/// FNV-1a, 64 bits.
class Hash {
public:
    template <typename T>
    Hash& add(const T& value) {
        static_assert(std::is_trivially_copyable_v<T> && alignof(T) == 4, "no padding");
        return bytes(reinterpret_cast<const unsigned char*>(&value), sizeof value);
    }
    Hash& add(const std::string& text) {
        return bytes(reinterpret_cast<const unsigned char*>(text.c_str()), text.size() + 1);
    }
    /// But for the flare, which came later.
    Hash& add(const GrownTreeParameters& wood) {
        constexpr std::size_t flare = offsetof(GrownTreeParameters, flare), after = flare + sizeof wood.flare;
        const auto* first = reinterpret_cast<const unsigned char*>(&wood);
        return bytes(first, flare).bytes(first + after, sizeof wood - after);
    }
    /// But for its strength and what it does in a breeze, which came later.
    Hash& add(const WoodParameters& wood) {
        constexpr std::size_t breeze = offsetof(WoodParameters, breezeStreamlining),
                              after = breeze + sizeof wood.breezeStreamlining;
        const auto* first = reinterpret_cast<const unsigned char*>(&wood);
        return bytes(first, breeze).bytes(first + after, offsetof(WoodParameters, bendingStrength) - after);
    }
    /// But for the area of cards, which follows LeafCoverage.h, and fronds, which came later.
    Hash& add(const LeafParameters& leaves) {
        return bytes(reinterpret_cast<const unsigned char*>(&leaves), offsetof(LeafParameters, frond))
            .add(leaves.seed);
    }
    std::uint64_t value() const { return _value; }

private:
    Hash& bytes(const unsigned char* first, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
            _value = (_value ^ first[i]) * 0x100000001b3u;
        return *this;
    }
    std::uint64_t _value = 0xcbf29ce484222325u;
};

/// Of every field that those tables had, bit by bit.
std::uint64_t hashOf(const Species& species) {
    Hash hash;
    hash.add(species.name);
    for (const std::string& alias : species.aliases)
        hash.add(alias);
    hash.add(species.source);
    hash.add(species.tree.wood).add(*species.tree.grown).add(species.tree.leaves);
    hash.add(3); // shapes that a species had by default
    const CrownAllometry& crown = species.crown;
    hash.add(crown.base).add(crown.perDiameter).add(crown.openBase).add(crown.openPerDiameter);
    hash.add(species.wood).add(species.branch);
    const LeafMotion& leaf = species.leaf;
    hash.add(leaf.maxAngleX).add(leaf.maxAngleZ).add(leaf.maxRotation).add(leaf.partialSteps);
    hash.add(leaf.factor).add(leaf.linkedFactor).add(leaf.noiseFrequency);
    const Appearance& looks = species.appearance;
    hash.add(looks.bark).add(looks.leaves).add(looks.springLeaves).add(looks.autumnLeaves);
    return hash.add(looks.leafForm).add(looks.barkForm).value();
}

} // namespace

TEST(BuiltInSpecies, AreWhatTheyWereToTheLastBit) {
    // Of the tables in C++ that species.treewind took the place of, but for the cards of palms and lindens
    // and the leaves of sycamores, Norway maples and red oaks.
    const std::vector<std::pair<const char*, std::uint64_t>> were = {{"Norway spruce", 0xc33fcce02622824e},
                                                                     {"Sitka spruce", 0x84eac131a0ee769a},
                                                                     {"Douglas fir", 0x969e356436b1eff4},
                                                                     {"grand fir", 0x611b4ecd4d9db256},
                                                                     {"western hemlock", 0xe9183eb8d1f21d00},
                                                                     {"Scots pine", 0x43888a75de81f108},
                                                                     {"lodgepole pine", 0x590beb0ec4299b69},
                                                                     {"Corsican pine", 0xe07b0e3ea241cb98},
                                                                     {"radiata pine", 0x2f5f812a7d901209},
                                                                     {"white spruce", 0xa5af1b49a3a0fa72},
                                                                     {"balsam fir", 0x586e1d954eb61429},
                                                                     {"European larch", 0x5935bb74ffe23d08},
                                                                     {"silver birch", 0x9f1a3fb81cbd08c6},
                                                                     {"beech", 0x1df1692368a9b8ae},
                                                                     {"oak", 0x015a42147df55009},
                                                                     {"ash", 0xf2154b687f0614b4},
                                                                     {"sycamore", 0x935198c89450780e},
                                                                     {"red maple", 0x999b17f4138b4912},
                                                                     {"red oak", 0x415c1243d7a5a56f},
                                                                     {"aspen", 0x5566a2077e768cc2},
                                                                     {"linden", 0xca461087099db661},
                                                                     {"poplar", 0x87fb2a58ae06d868},
                                                                     {"London plane", 0xd01d65b95d2643eb},
                                                                     {"honey locust", 0x5bd65a4e18f0a7de},
                                                                     {"Norway maple", 0x5d5d3055155dcb53},
                                                                     {"horse chestnut", 0xb4c80d16c66ee561},
                                                                     {"ginkgo", 0x8c51bc1772c0c354},
                                                                     {"palm", 0x5fe263d71be8e637},
                                                                     {"conifer", 0x6d3f3b36a4bfddd7},
                                                                     {"broadleaf", 0xc871b8e90db84153}};
    const auto& all = SpeciesCatalogue::builtIn().species();
    ASSERT_EQ(all.size(), were.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i].name, were[i].first);
        EXPECT_EQ(hashOf(all[i]), were[i].second) << all[i].name;
        EXPECT_FALSE(all[i].tree.scans || all[i].appearance.evergreen) << all[i].name;
        EXPECT_EQ(all[i].appearance.leafImage + all[i].appearance.barkImage, "") << all[i].name;
    }
}

TEST(BuiltInSpecies, BearWhatGreenWoodDoes) {
    for (const Species& species : SpeciesCatalogue::builtIn().species()) {
        if (species.name == "palm") // nobody knows
            continue;
        // Of all in the Wood Handbook: northern white cedar to shellbark hickory.
        EXPECT_GE(species.wood.bendingStrength, 29.0e6f) << species.name;
        EXPECT_LE(species.wood.bendingStrength, 72.0e6f) << species.name;
    }
}

TEST(BuiltInSpecies, ThereAreAtLeastTwelveAndEachHasASource) {
    const auto& all = SpeciesCatalogue::builtIn().species();
    std::size_t conifers = 0;
    for (const Species& species : all) {
        EXPECT_FALSE(species.source.empty()) << species.name;
        conifers += species.appearance.needles();
    }
    EXPECT_GE(all.size(), 12u);
    EXPECT_GE(conifers, 5u);
    EXPECT_GE(all.size() - conifers, 5u);
}

TEST(BuiltInSpecies, AreFoundByCommonAndScientificNameInAnyCase) {
    ASSERT_TRUE(findSpecies("oak"));
    EXPECT_EQ(findSpecies("QUERCUS ROBUR")->name, "oak");
    EXPECT_EQ(findSpecies("Picea abies")->name, "Norway spruce");
    EXPECT_FALSE(findSpecies("lamp post"));
    EXPECT_FALSE(findSpecies(""));
    EXPECT_EQ(defaultSpecies().name, "broadleaf");
}

TEST(BuiltInSpecies, ModuliAreThoseOfTheTable) {
    // ForestGALES: Sitka spruce 5.9 GPa, C 2.35, n 0.51; beech 9.8 GPa, C 2.4141, n 0.904.
    const Species sitka = *findSpecies("Sitka spruce"), beech = *findSpecies("beech");
    EXPECT_FLOAT_EQ(sitka.wood.elasticModulus, 5.9e9f);
    EXPECT_FLOAT_EQ(sitka.wood.crownDrag, 2.35f);
    EXPECT_FLOAT_EQ(sitka.wood.streamlining, 0.51f);
    EXPECT_FLOAT_EQ(beech.wood.elasticModulus, 9.8e9f);
    EXPECT_NEAR(beech.wood.crownDrag, 2.4141f, 1e-3f);
    EXPECT_FLOAT_EQ(beech.wood.streamlining, 0.904f);
}

TEST(BuiltInSpecies, ConifersHaveTheVolumesOfForestry) {
    // Stem over trunk section at breast height times height: 0.4 to 0.5 (form factor); branches 0.15 to 0.2
    // of the wood (Jenkins et al. 2003).
    for (const Species& species : SpeciesCatalogue::builtIn().species()) {
        if (!species.appearance.needles())
            continue;
        const TreeModel model = makeTreeModel(species.tree, 0);
        const TreeScale scale = fitTree(model, {20.0f, 0.3f, 0.0f});
        double stem = 0.0, branches = 0.0;
        for (const BranchUnit& unit : model.skeleton.units) {
            const double a = unit.baseRadius * scale.radius, b = unit.tipRadius * scale.radius;
            const double length = glm::length(scale.axes * (unit.tip - unit.base));
            (unit.level == 0 ? stem : branches) += 3.141592653589793 / 3.0 * length * (a * a + a * b + b * b);
        }
        const double form = stem / (3.141592653589793 * 0.15 * 0.15 * 20.0);
        EXPECT_GT(form, 0.4) << species.name;
        EXPECT_LT(form, 0.5) << species.name;
        EXPECT_GT(branches / (stem + branches), 0.15) << species.name;
        EXPECT_LT(branches / (stem + branches), 0.2) << species.name;
    }
}

TEST(BuiltInSpecies, CrownsOfTownTreesAre22To28TimesAsWideAsTheirStems) {
    // Coombes, Martin, Slater 2019.
    for (const char* name : {"oak", "sycamore", "silver birch", "Norway maple"}) {
        float sum = 0.0f;
        for (std::uint32_t shape = 0; shape < 3; ++shape) {
            const TreeSize size = measureTree(makeTreeModel(findSpecies(name)->tree, shape));
            sum += size.crownWidth / size.trunkDiameter / 3.0f;
        }
        EXPECT_GT(sum, 22.0f) << name;
        EXPECT_LT(sum, 28.0f) << name;
    }
}

TEST(BuiltInSpecies, LeavesDrawnHaveTheAreaOfTheMechanics) {
    for (const Species& species : SpeciesCatalogue::builtIn().species()) {
        const TreeModel model = makeTreeModel(species.tree);
        const float card = glm::distance(model.leafMesh[0].corner, model.leafMesh[1].corner) *
                           glm::distance(model.leafMesh[1].corner, model.leafMesh[2].corner);
        float drawn = 0.0f;
        for (const LeafCluster& leaf : model.leaves)
            drawn += quadsPerLeafCluster * leaf.size * leaf.size * card;
        drawn *= leafCoverage(species.appearance.leafForm);
        EXPECT_NEAR(drawn / leafArea(model, {}, species), 1.0f, 0.2f) << species.name;
    }
}

TEST(BuiltInSpecies, AreCheapEnoughToDraw) {
    for (const Species& species : SpeciesCatalogue::builtIn().species())
        for (std::uint32_t shape = 0; shape < 3; ++shape) {
            const TreeModel model = makeTreeModel(species.tree, shape);
            EXPECT_LE(model.skeleton.units.size(), 300u) << species.name;
            EXPECT_LE(model.leaves.size(), 1900u) << species.name;
        }
}

TEST(BuiltInSpecies, RoundStemsAndCollarsCostATwentiethMoreThanEightSidesEach) {
    for (const Species& species : SpeciesCatalogue::builtIn().species()) {
        const TreeCounts counts = countTree(species.tree);
        const double before =
            8.0 * static_cast<double>(counts.skeletonPoints) + static_cast<double>(counts.leafVertices);
        EXPECT_LE(static_cast<double>(counts.totalVertices()) / before, 1.05) << species.name;
    }
}

TEST(BuiltInSpecies, StandOnFeet) {
    const auto flare = [](const char* name) { return findSpecies(name)->tree.grown->flare; };
    for (const Species& species : SpeciesCatalogue::builtIn().species())
        EXPECT_GT(species.tree.grown->flare, 0.2f) << species.name;
    EXPECT_GT(flare("beech"), flare("silver birch"));
    EXPECT_GT(flare("oak"), flare("palm"));
}

TEST(BuiltInSpecies, TreesOfACampusFindTheirKind) {
    // What botanists call the trees of the University of Utah.
    const std::vector<std::pair<const char*, const char*>> kinds = {
        {"Gleditsia triacanthos", "honey locust"},
        {"Pinus nigra", "Corsican pine"},
        {"Acer saccharinum", "red maple"},
        {"Platanus x acerifolia", "London plane"},
        {"Pyrus spp.", "broadleaf"},
        {"Picea pungens", "white spruce"},
        {"Acer platanoides", "Norway maple"},
        {"Malus spp.", "broadleaf"},
        {"Quercus macrocarpa", "oak"},
        {"Fagus sylvatica", "beech"},
        {"Zelkova serrata", "broadleaf"},
        {"Fraxinus pennsylvanica", "ash"},
        {"Pseudotsuga menziesii", "Douglas fir"},
        {"Morus alba", "broadleaf"},
        {"Prunus spp.", "broadleaf"},
        {"Tilia cordata", "linden"},
        {"Ulmus pumila", "broadleaf"},
        {"Aesculus hippocastanum", "horse chestnut"},
        {"Pinus ponderosa", "Corsican pine"},
        {"Betula pendula", "silver birch"},
        {"Koelreuteria paniculata", "broadleaf"},
        {"Crataegus x lavallei", "broadleaf"},
        {"Cercis canadensis", "broadleaf"},
        {"Gymnocladus dioicus", "honey locust"},
        {"Populus sargentii", "aspen"},
        {"Juniperus virginiana", "conifer"},
        {"Carpinus betulus 'Fastigiata'", "broadleaf"},
        {"Robinia pseudoacacia", "honey locust"},
        {"Rhus lancea", "broadleaf"},
        {"Ginkgo biloba", "ginkgo"},
        {"Cedrus deodara", "conifer"},
        {"Magnolia grandiflora", "broadleaf"},
        {"Liriodendron tulipifera", "broadleaf"},
        {"Liquidambar styraciflua", "broadleaf"}};
    for (const auto& [name, kind] : kinds) {
        ASSERT_TRUE(findSpecies(name)) << name;
        EXPECT_EQ(findSpecies(name)->name, kind) << name;
    }
}
