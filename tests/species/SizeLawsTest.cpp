// SPDX-License-Identifier: MIT
#include <osgTreeWind/species/SizeLaws.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <tests/Folders.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>

using namespace osgTreeWind;

namespace {

constexpr int many = 10000;

TreeSize sizeOf(float height, float trunkDiameter, float crownWidth = 0.0f) {
    return {height, trunkDiameter, crownWidth};
}

struct Spread {
    double mean = 0.0, deviation = 0.0, most = 0.0;
};

/// Statistics of `value` over the estimates of many trees with different ids.
Spread spreadOf(const TreeSize& given, const Species& species, bool openGrown,
                const std::function<double(const TreeSize&)>& value) {
    double sum = 0.0, squares = 0.0;
    Spread spread;
    for (int i = 0; i < many; ++i) {
        const double x = value(estimateSize(given, species, openGrown, "T " + std::to_string(i)).size);
        sum += x;
        squares += x * x;
        spread.most = std::max(spread.most, std::abs(x));
    }
    spread.mean = sum / many;
    spread.deviation = std::sqrt((squares - sum * spread.mean) / (many - 1));
    return spread;
}

/// Expects logarithms with mean 0 and standard deviation `deviation`, within the sampling error, and at most
/// two standard deviations from the law.
void expectSpread(const Spread& found, double deviation) {
    EXPECT_NEAR(found.mean, 0.0, 4.0 * deviation / std::sqrt(many));
    EXPECT_NEAR(found.deviation, deviation, 0.02 * deviation);
    EXPECT_LE(found.most, 2.0 * deviation + 1e-6);
    EXPECT_GT(found.most, 1.95 * deviation);
}

struct Moments {
    double mean, deviation; // of ln(diameter)
};

/// Diameters of trees with a height, and with a crown width if it is above 0: Bayes' theorem in small steps.
Moments diametersOf(const Species& species, bool open, double height, double width = 0.0) {
    const HeightAllometry& law = species.height;
    const CrownAllometry& crown = species.crown;
    const auto normal = [](double x, double deviation) {
        return std::exp(-0.5 * x * x / deviation / deviation);
    };
    double weights = 0.0, sum = 0.0, squares = 0.0;
    for (double x = std::log(0.002); x < std::log(20.0); x += 1e-3) {
        const double d = std::exp(x);
        const double high = open ? law.openScale * std::pow(d, static_cast<double>(law.openPower))
                                 : law.scale * std::pow(d, static_cast<double>(law.power));
        const double wide =
            open ? crown.openBase + crown.openPerDiameter * d : crown.base + crown.perDiameter * d;
        double weight = normal(std::log(d / (open ? law.openDiameter : law.diameter)),
                               open ? law.openDiameterSpread : law.diameterSpread) *
                        normal(std::log(height / high), open ? law.openSpread : law.spread);
        if (width > 0.0)
            weight *= normal(std::log(width / wide), open ? crown.openSpread : crown.spread);
        weights += weight, sum += weight * x, squares += weight * x * x;
    }
    const double mean = sum / weights;
    return {mean, std::sqrt(squares / weights - mean * mean)};
}

/// A source as in the table of docs/species.md, which leaves out the names of the databases.
std::string withoutDatabases(std::string source) {
    for (const std::string database :
         {"BAAD (Falster et al. 2015), ", "in the open Urban Tree Database (McPherson et al. 2016), ",
          "Urban Tree Database (McPherson et al. 2016), "})
        if (const std::size_t at = source.find(database); at != std::string::npos)
            source.erase(at, database.size());
    return source;
}

} // namespace

TEST(SizeLaws, HeightsHaveThePublishedMeanAndSpread) {
    for (const char* name : {"oak", "Norway spruce"})
        for (const bool open : {false, true}) {
            SCOPED_TRACE(std::string(name) + (open ? " in the open" : " in a forest"));
            const Species species = *findSpecies(name);
            const HeightAllometry& law = species.height;
            const double known = std::log((open ? law.openScale : law.scale) *
                                          std::pow(0.4f, open ? law.openPower : law.power));
            const auto off = [&](const TreeSize& size) { return std::log(size.height) - known; };
            expectSpread(spreadOf(sizeOf(0.0f, 0.4f), species, open, off),
                         static_cast<double>(open ? law.openSpread : law.spread));
        }
}

TEST(SizeLaws, DiametersAreThoseOfTheTreesWithTheirHeight) {
    for (const char* name : {"oak", "Norway spruce"})
        for (const bool open : {false, true})
            for (const float height : {8.0f, 15.0f, 28.0f}) {
                SCOPED_TRACE(std::string(name) + (open ? " in the open, " : " in a forest, ") +
                             std::to_string(height));
                const Species species = *findSpecies(name);
                const Moments known = diametersOf(species, open, height);
                const auto off = [&](const TreeSize& size) {
                    return std::log(size.trunkDiameter) - known.mean;
                };
                expectSpread(spreadOf(sizeOf(height, 0.0f), species, open, off), known.deviation);
                EXPECT_NEAR(estimateSize(sizeOf(height, 0.0f), species, open, "a").diameterSpread,
                            known.deviation, 1e-3);
            }
}

TEST(SizeLaws, AMeasuredCrownNarrowsTheDiameters) {
    for (const char* name : {"oak", "Norway spruce"})
        for (const bool open : {false, true})
            for (const float width : {4.0f, 6.0f, 9.0f}) {
                SCOPED_TRACE(std::string(name) + (open ? " in the open, " : " in a forest, ") +
                             std::to_string(width));
                const Species species = *findSpecies(name);
                const TreeSize given = sizeOf(18.0f, 0.0f, width);
                const Moments known = diametersOf(species, open, 18.0f, width);
                const auto off = [&](const TreeSize& size) {
                    return std::log(size.trunkDiameter) - known.mean;
                };
                const Spread found = spreadOf(given, species, open, off);
                EXPECT_NEAR(found.mean, 0.0, 0.03);
                EXPECT_NEAR(found.deviation, known.deviation, 0.02);
                EXPECT_LT(found.deviation, 0.9 * diametersOf(species, open, 18.0f).deviation);
            }
}

TEST(SizeLaws, DiametersUnderACrownAreThoseOfJucker2017) {
    const Species broadleaf = *findSpecies("broadleaf");
    double sum = 0.0, squares = 0.0;
    int count = 0;
    for (const float height : {10.0f, 15.0f, 20.0f, 25.0f, 30.0f})
        for (const float width : {3.0f, 5.0f, 8.0f, 12.0f}) {
            const double jucker = 0.00557 * std::pow(height * width, 0.809) * std::exp(0.056 / 2.0);
            const auto off = [&](const TreeSize& size) { return std::log(size.trunkDiameter / jucker); };
            const double mean = spreadOf(sizeOf(height, 0.0f, width), broadleaf, false, off).mean;
            sum += mean, squares += mean * mean, ++count;
        }
    EXPECT_NEAR(sum / count, 0.0, 0.1);
    EXPECT_LT(std::sqrt(squares / count), 0.24) << "the deviation of the published relation";
}

TEST(SizeLaws, CrownsHaveThePublishedSpread) {
    const Species oak = *findSpecies("oak");
    const auto off = [](const TreeSize& size) { return std::log(size.crownWidth / (0.95 + 21.9 * 0.4)); };
    expectSpread(spreadOf(sizeOf(12.0f, 0.4f), oak, true, off), 0.26);
}

TEST(SizeLaws, DiameterOfTheMeanHeightIsTheMeanDiameter) {
    Species oak = *findSpecies("oak");
    oak.height.spread = 0.0f;
    const float height = estimateSize(sizeOf(0.0f, 0.37f), oak, false, "a").size.height;
    EXPECT_NEAR(estimateSize(sizeOf(height, 0.0f), oak, false, "b").size.trunkDiameter, 0.37f, 1e-6f);
}

TEST(SizeLaws, ResidualsOfAnIdNeverChange) {
    EXPECT_DOUBLE_EQ(residual("T 7", "height"), 0.4089821988301634);
    EXPECT_DOUBLE_EQ(residual("T 7", "crown_width"), 0.40668043177461799);
    EXPECT_DOUBLE_EQ(residual("", "height"), -1.009512978524719);
}

TEST(SizeLaws, ResidualsAreUncorrelated) {
    double ofCrown = 0.0, ofNext = 0.0;
    for (int i = 0; i < many; ++i) {
        const double height = residual(std::to_string(i), "height");
        ofCrown += height * residual(std::to_string(i), "crown_width") / many;
        ofNext += height * residual(std::to_string(i + 1), "height") / many;
    }
    EXPECT_NEAR(ofCrown, 0.0, 4.0 / std::sqrt(many));
    EXPECT_NEAR(ofNext, 0.0, 4.0 / std::sqrt(many));
}

TEST(SizeLaws, GivenSizesStay) {
    const Species oak = *findSpecies("oak");
    const SizeEstimate tree = estimateSize(sizeOf(9.0f, 0.3f, 4.0f), oak, true, "a");
    EXPECT_EQ(tree.size.height, 9.0f);
    EXPECT_EQ(tree.size.trunkDiameter, 0.3f);
    EXPECT_EQ(tree.size.crownWidth, 4.0f);
    EXPECT_FALSE(tree.estimated.height || tree.estimated.trunkDiameter || tree.estimated.crownWidth);
    const SizeEstimate tall = estimateSize(sizeOf(9.0f, 0.01f), oak, true, "a");
    EXPECT_EQ(tall.size.height, 9.0f) << "even if no tree is so slender";
    EXPECT_EQ(tall.size.trunkDiameter, 0.01f);
}

TEST(SizeLaws, FlagsEstimatedSizes) {
    const Species oak = *findSpecies("oak");
    const EstimatedSizes ofTrunk = estimateSize(sizeOf(0.0f, 0.3f), oak, true, "a").estimated;
    EXPECT_TRUE(ofTrunk.height && ofTrunk.crownWidth && !ofTrunk.trunkDiameter);
    const EstimatedSizes ofHeight = estimateSize(sizeOf(9.0f, 0.0f), oak, true, "a").estimated;
    EXPECT_TRUE(!ofHeight.height && ofHeight.crownWidth && ofHeight.trunkDiameter);
    const EstimatedSizes ofCrown = estimateSize(sizeOf(0.0f, 0.0f, 8.0f), oak, true, "a").estimated;
    EXPECT_TRUE(ofCrown.height && !ofCrown.crownWidth && ofCrown.trunkDiameter);
}

TEST(SizeLaws, EstimatesTheDiameterFromTheCrownAlone) {
    Species oak = *findSpecies("oak");
    oak.crown.openSpread = 0.0f;
    const auto trunkUnder = [&](float crown) {
        return estimateSize(sizeOf(0.0f, 0.0f, crown), oak, true, "a").size.trunkDiameter;
    };
    EXPECT_NEAR(trunkUnder(0.95f + 21.9f * 0.4f), 0.4f, 1e-5f);
    EXPECT_NEAR(trunkUnder(0.5f), 0.0122f, 1e-3f) << "narrower than the law's constant";
    EXPECT_LT(trunkUnder(0.5f), trunkUnder(1.5f));
}

TEST(SizeLaws, VariesTheTypicalTreeWithoutGivenSizes) {
    const Species oak = *findSpecies("oak");
    const SizeEstimate tree = estimateSize({}, oak, false, "a");
    EXPECT_TRUE(tree.estimated.height);
    EXPECT_EQ(tree.size.trunkDiameter, 0.0f) << "in proportion";
    EXPECT_EQ(tree.size.crownWidth, 0.0f);
    const auto off = [&](const TreeSize& size) {
        return std::log(size.height / static_cast<double>(oak.tree.growth->size.height));
    };
    expectSpread(spreadOf({}, oak, false, off), static_cast<double>(oak.height.spread));
}

TEST(SizeLaws, LimitsTheSlendernessOfEstimates) {
    Species species = *findSpecies("oak");
    species.height.spread = 0.0f; // the line alone decides
    const auto slenderness = [&](const TreeSize& given) {
        const TreeSize size = estimateSize(given, species, false, "a").size;
        return size.height / size.trunkDiameter;
    };
    EXPECT_NEAR(slenderness(sizeOf(0.0f, 0.001f)), 150.0f, 0.01f);
    EXPECT_NEAR(slenderness(sizeOf(0.01f, 0.0f)), 150.0f, 0.01f);
    species.height.power = 0.1f;
    EXPECT_NEAR(slenderness(sizeOf(150.0f, 0.0f)), 15.0f, 0.01f);
    species.height.scale = 1.0f;
    EXPECT_NEAR(slenderness(sizeOf(0.0f, 0.9f)), 15.0f, 0.01f);
}

TEST(SizeLaws, VeryThickTreesAreHardlyHigherOrWider) {
    for (const char* const name : {"oak", "Norway spruce", "London plane", "broadleaf"}) {
        const Species species = *findSpecies(name);
        const TreeSize large = estimateSize(sizeOf(0.0f, 1.0f), species, true, "a").size,
                       huge = estimateSize(sizeOf(0.0f, 7.0f), species, true, "a").size;
        EXPECT_GE(huge.height, large.height) << name;
        EXPECT_LT(huge.height, 1.8f * large.height) << name;
        EXPECT_LT(huge.height, 80.0f) << name;
        EXPECT_GE(huge.crownWidth, large.crownWidth) << name;
        EXPECT_LT(huge.crownWidth, 2.1f * large.crownWidth) << name;
        EXPECT_LE(huge.crownWidth, 50.0f) << name;
    }
}

TEST(SizeLaws, EstimatesEndAtTheRecordOfTheSpecies) {
    for (const Species& species : SpeciesCatalogue::builtIn().species()) {
        SCOPED_TRACE(species.name);
        if (species.name == "conifer" || species.name == "broadleaf")
            continue; // these stand for many species
        ASSERT_GT(species.height.largest, usualHeight(species));
        if (species.tree.growth && species.crown.largest > 0.0f) {
            EXPECT_GT(species.crown.largest, species.tree.growth->size.crownWidth);
        }
        const float widest = species.crown.largest > 0.0f ? species.crown.largest : 50.0f;
        for (int id = 0; id < 200; ++id)
            for (const bool open : {false, true}) {
                const TreeSize size =
                    estimateSize(sizeOf(0.0f, 8.0f), species, open, std::to_string(id)).size;
                EXPECT_LE(size.height, species.height.largest);
                EXPECT_LE(size.crownWidth, widest);
            }
        const TreeSize whole = completeSize(sizeOf(0.0f, 8.0f), species, true);
        EXPECT_LE(whole.height, species.height.largest);
        EXPECT_LE(whole.crownWidth, widest);
    }
    const Species oak = *findSpecies("oak");
    EXPECT_EQ(estimateSize(sizeOf(80.0f, 0.0f), oak, true, "a").size.height, 80.0f) << "a given size stays";
}

TEST(SizeLaws, SizesWithoutALawStayUnknown) {
    const SizeEstimate tree = estimateSize(sizeOf(0.0f, 0.3f), Species(), false, "a");
    EXPECT_EQ(tree.size.height, 0.0f);
    EXPECT_EQ(tree.size.crownWidth, 0.0f);
    EXPECT_FALSE(tree.estimated.height || tree.estimated.crownWidth);
    EXPECT_EQ(estimateSize({}, Species(), false, "a").size.height, 0.0f);
}

TEST(SizeLaws, EstimatesAreInRangeUnderAnyLaw) {
    Species species = *findSpecies("oak");
    for (const float scale : {1e-38f, 1.0f, 500.0f})
        for (const float power : {0.1f, 1.0f, 3.0f})
            for (const float spread : {0.0f, 2.0f})
                for (const float perDiameter : {0.0f, 1e-38f, 100.0f})
                    for (const TreeSize& given :
                         {sizeOf(0.0f, 0.0f), sizeOf(0.0f, 1e-6f), sizeOf(0.0f, 20.0f), sizeOf(1e-6f, 0.0f),
                          sizeOf(150.0f, 0.0f), sizeOf(0.0f, 0.0f, 1e-6f), sizeOf(0.0f, 0.0f, 150.0f),
                          sizeOf(1e-6f, 0.0f, 150.0f), sizeOf(150.0f, 0.0f, 1e-6f)}) {
                        species.height.scale = scale;
                        species.height.power = power;
                        species.height.spread = species.crown.spread = spread;
                        species.crown.perDiameter = perDiameter;
                        const SizeEstimate tree = estimateSize(given, species, false, "a");
                        const TreeSize& size = tree.size;
                        EXPECT_TRUE(size.height >= 0.0f && size.height <= 150.0f) << size.height;
                        EXPECT_TRUE(size.trunkDiameter >= 0.0f && size.trunkDiameter <= 20.0f)
                            << size.trunkDiameter;
                        EXPECT_TRUE(size.crownWidth >= 0.0f && size.crownWidth <= 150.0f) << size.crownWidth;
                        EXPECT_EQ(tree.estimated.height, size.height != given.height);
                        EXPECT_EQ(tree.estimated.trunkDiameter, size.trunkDiameter != given.trunkDiameter);
                        EXPECT_EQ(tree.estimated.crownWidth, size.crownWidth != given.crownWidth);
                    }
}

TEST(SizeLaws, EveryBuiltInSpeciesHasAHeightLawWithItsSource) {
    for (const Species& species : SpeciesCatalogue::builtIn().species()) {
        SCOPED_TRACE(species.name);
        const HeightAllometry& law = species.height;
        EXPECT_NE(law.source.find("Urban Tree Database"), std::string::npos) << law.source;
        EXPECT_GT(law.spread, 0.0f);
        EXPECT_GT(law.openSpread, 0.0f);
        for (const double diameter : {0.1, 0.3, 0.6}) { // within the range of measured trees
            const double open = law.openScale * std::pow(diameter, static_cast<double>(law.openPower));
            const double forest = law.scale * std::pow(diameter, static_cast<double>(law.power));
            EXPECT_GE(forest, open) << diameter;
            EXPECT_GT(open, 15.0 * diameter);
            EXPECT_LT(forest, 130.0 * diameter);
        }
    }
}

TEST(SizeLaws, MatchTheTableInTheDocumentation) {
    std::ifstream file(OSGTREEWIND_SOURCE_DIR "/docs/species.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (const Species& species : SpeciesCatalogue::builtIn().species()) {
        const HeightAllometry& law = species.height;
        std::ostringstream row;
        row << "| " << species.name << " | " << law.scale << "·d^" << law.power << " | " << law.spread
            << " | " << law.openScale << "·d^" << law.openPower << " | " << law.openSpread << " | "
            << withoutDatabases(law.source) << " |";
        EXPECT_NE(text.find(row.str()), std::string::npos) << row.str();
    }
}
