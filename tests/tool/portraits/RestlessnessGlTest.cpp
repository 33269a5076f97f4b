// SPDX-License-Identifier: MIT
// Flicker in pictures of a moving tree: 960 x 720 pixels, 40 degrees, 4 samples per pixel.
#include <examples/osgtreewind/pictures/OffscreenViewer.h>
#include <examples/osgtreewind/scene/Setting.h>

#include <tests/FullTests.h>
#include <tests/tool/portraits/LeafEdges.h>

#include <osgTreeWind/base/Luminance.h>
#include <osgTreeWind/drawing/instanced/TreeTiers.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/species/GrowthLaws.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

namespace {

using namespace osgTreeWind;

using Luminance = std::vector<double>; ///< Of each pixel, [0, 255].

/// Draws a tree at a distance in a picture that just holds it.
class TreeInView {
public:
    TreeInView(const Species& species, double distance, int samplesAcross)
        : _forest(new Forest(describe(species))), _size(sizeOf(*_forest)), _samplesAcross(samplesAcross),
          _perMetre(static_cast<double>(EdgePicture::pixelsPerMetreAt1m) / distance),
          _viewer(pixels(1.1f * _size.crownWidth), pixels(1.1f * _size.height), samplesAcross) {
        osg::Camera& camera = *_viewer.viewer().getCamera();
        const double height = camera.getViewport()->height(), width = camera.getViewport()->width();
        const double half =
            0.5 * height / (samplesAcross * static_cast<double>(EdgePicture::pixelsPerMetreAt1m));
        camera.setProjectionMatrixAsFrustum(-half * width / height, half * width / height, -half, half, 1.0,
                                            2.0 * distance + 1000.0);
        const double middle = 0.5 * static_cast<double>(_size.height);
        camera.setViewMatrixAsLookAt({0.36 * distance, -0.93 * distance, middle}, {0.0, 0.0, middle},
                                     osg::Z_AXIS);
        SettingOptions setting;
        setting.shadows = false; // most of the time, and little of the picture
        _viewer.viewer().setSceneData(createSetting(*_forest, setting));
    }

    /// @param seenAs factor on the screen height by which the tier is chosen.
    Luminance frame(double time, double seenAs = 1.0) {
        _viewer.viewer().getCamera()->setLODScale(static_cast<float>(_samplesAcross / seenAs));
        const osg::Image& image = _viewer.frame(time);
        Luminance values;
        for (int y = 0; y < image.t(); ++y)
            for (int x = 0; x < image.s(); ++x) {
                const unsigned char* rgb = image.data(static_cast<unsigned>(x), static_cast<unsigned>(y));
                values.push_back(static_cast<double>(luminance({rgb[0], rgb[1], rgb[2]})));
            }
        return values;
    }

private:
    static ForestDescription describe(const Species& species) {
        ForestDescription forest;
        forest.species = {species};
        forest.trees.resize(1);
        forest.wind = std::make_shared<UniformWind>(glm::vec3(2.0f, 0.0f, 0.0f));
        return forest;
    }
    static TreeSize sizeOf(const Forest& forest) {
        const ForestSimulation& simulation = forest.getSimulation();
        return movingForest(simulation).placed().sizeOf(movingForest(simulation).trees().front());
    }
    int pixels(float metres) const {
        return static_cast<int>(std::lround(_perMetre * static_cast<double>(metres)));
    }

    osg::ref_ptr<Forest> _forest;
    TreeSize _size;
    int _samplesAcross;
    double _perMetre;
    OffscreenViewer _viewer;
};

/// Root mean square change of luminance from frame to frame.
double changeOf(const Species& species, int samplesAcross) {
    constexpr int frames = 4;
    TreeInView tree(species, 40.0, samplesAcross);
    double time = 0.0, sum = 0.0;
    for (; time < 2.5; time += 1.0) // the tree starts at rest
        tree.frame(time);
    Luminance before = tree.frame(time);
    for (int i = 0; i < frames; ++i) {
        const Luminance now = tree.frame(time += 1.0 / 30.0);
        for (std::size_t pixel = 0; pixel < now.size(); ++pixel)
            sum +=
                (now[pixel] - before[pixel]) * (now[pixel] - before[pixel]) / static_cast<double>(now.size());
        before = now;
    }
    return std::sqrt(sum / frames);
}

/// Screen heights, in whole pixels, below which the next tier begins.
std::vector<double> thresholds() {
    const TreeTiers tiers;
    std::vector<double> heights;
    for (float pixels = DrawingOptions().full; pixels > 0.0f; --pixels)
        if (tiers.choose(pixels).fade == 1.0f && tiers.choose(pixels - 1.0f).fade < 1.0f)
            heights.push_back(pixels);
    return heights;
}

double changedShare(const Luminance& a, const Luminance& b) {
    std::size_t changed = 0;
    for (std::size_t pixel = 0; pixel < a.size(); ++pixel)
        changed += std::abs(a[pixel] - b[pixel]) > 16.0;
    return static_cast<double>(changed) / static_cast<double>(a.size());
}

/// Change from one tier of detail to the next, as shares of the pixels around the tree whose luminance
/// differs by more than 16 of 255.
struct Pop {
    double apart; ///< Difference between the two tiers.
    double pop;   ///< Largest change in one frame when approaching at 2 m/s.
};

/// @param pixels height of the tree on the screen.
Pop popAt(const Species& species, double height, double pixels) {
    const double distance = static_cast<double>(EdgePicture::pixelsPerMetreAt1m) * height / pixels;
    TreeInView tree(species, distance, 2);
    const auto seen = [&](double seenAs) {
        tree.frame(0.0, seenAs); // what is seen for the first time appears in the next frame
        return tree.frame(0.0, seenAs);
    };
    const double blend = DrawingOptions().blend, nearer = 1.0 + 2.0 / 30.0 / distance;
    Pop pop{changedShare(seen(1.01), seen(0.99 * (1.0 - blend))), 0.0};
    for (const double fade : {0.02, 0.25, 0.5, 0.75, 0.98}) {
        const double at = 1.0 - blend * fade;
        pop.pop = std::max(pop.pop, changedShare(seen(at), seen(at * nearer)));
    }
    return pop;
}

} // namespace

/// Prints a row of the table in docs/species.md.
TEST(RestlessnessGlTest, FewSamplesFlickerLittleAndTiersCrossOver) {
    const std::vector<double> heights = thresholds();
    EXPECT_EQ(heights, (std::vector<double>{800.0, 543.0, 369.0, 250.0, 80.0}));
    const char* const all[] = {"palm", "Norway spruce", "Scots pine", "silver birch", "oak"};
    for (int i = 0; i < casesToRun(5, 1); ++i) {
        Species species = *findSpecies(all[i]);
        species.tree = growthOf(species, true);
        const double fine = changeOf(species, 8), flicker = changeOf(species, 2) / fine;
        std::printf("%s: flicker %.1f, with 16 samples %.1f; pop, apart:", all[i], flicker,
                    changeOf(species, 4) / fine);
        EXPECT_GT(flicker, 0.9) << "fewer samples are no calmer";
        EXPECT_LT(flicker, 5.0);
        const double height = measureTree(makeTreeModel(species.tree)).height;
        for (const double pixels : heights) {
            const Pop tiers = popAt(species, height, pixels);
            std::printf(" %.3f %.2f", tiers.pop, tiers.apart);
            EXPECT_GT(tiers.apart, 0.01) << "no other tier: " << pixels;
            EXPECT_LT(tiers.pop, 0.3 * tiers.apart) << "tiers cross over: " << pixels;
        }
        std::printf("\n");
    }
}
