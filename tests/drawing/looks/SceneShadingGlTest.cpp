// SPDX-License-Identifier: MIT
#include <tests/NamesInOrder.h>
#include <tests/gl/GlTest.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/nodes/Pictures.h>

#include <osgTreeWind/base/Luminance.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>

#include <osg/Fog>
#include <osg/LightModel>
#include <osg/LightSource>
#include <osg/MatrixTransform>
#include <osg/ShapeDrawable>
#include <osgShadow/ShadowMap>
#include <osgShadow/ShadowedScene>
#include <osgShadow/ViewDependentShadowMap>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace osgTreeWind;

namespace {

constexpr int pictureSize = 128;

/// Mean colour of the pixels that differ from the background.
osg::Vec3d meanColour(const osg::Image& image) {
    osg::Vec3d sum;
    int pixels = 0;
    for (int i = 0; i < image.s() * image.t(); ++i) {
        const unsigned char* p = image.data() + 4 * i;
        if (p[0] || p[1] || p[2]) {
            sum += osg::Vec3d(p[0], p[1], p[2]);
            ++pixels;
        }
    }
    return sum / std::max(pixels, 1);
}

osg::ref_ptr<osg::LightSource> lightSource(int number, const osg::Vec4& position, const osg::Vec4& diffuse) {
    osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
    osg::Light& light = *source->getLight();
    light.setLightNum(number);
    light.setPosition(position);
    light.setDiffuse(diffuse);
    light.setAmbient(osg::Vec4(0, 0, 0, 1));
    return source;
}

/// A tree in still air on a black background, lit by the lights of the test. Colours are linear.
class SceneShadingGlTest : public GlTest {
protected:
    SceneShadingGlTest() : scene(new osg::Group), forest(new Forest(oneTree(smallSpecies(), 0.0f))) {
        scene->addChild(forest);
        osg::ref_ptr<osg::LightModel> model = new osg::LightModel;
        model->setAmbientIntensity(osg::Vec4(0.1f, 0.1f, 0.1f, 1.0f));
        scene->getOrCreateStateSet()->setAttribute(model);
        scene->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::ON);
        scene->getOrCreateStateSet()->setDefine("LINEAR_COLORS");
    }
    void light(osg::LightSource* source) {
        scene->addChild(source);
        source->setStateSetModes(*scene->getOrCreateStateSet(), osg::StateAttribute::ON);
    }
    /// The tree from the south, at the same size from any distance (metres).
    osg::ref_ptr<osg::Image> picture(double distance = 20.0, int pixels = pictureSize, int samples = 0,
                                     double half = 3.0, float lodScale = 1.0f) {
        reopen(pixels, pixels, samples);
        viewer().setSceneData(scene);
        viewer().setLightingMode(osg::View::NO_LIGHT);
        osg::Camera& camera = *viewer().getCamera();
        camera.setProjectionMatrixAsPerspective(2.0 * osg::RadiansToDegrees(std::atan(half / distance)), 1.0,
                                                1.0, 500.0);
        camera.setViewMatrixAsLookAt(osg::Vec3d(0, -distance, 2.5), osg::Vec3d(0, 0, 2.5),
                                     osg::Vec3d(0, 0, 1));
        camera.setLODScale(lodScale);
        camera.setClearColor(background);
        frame(0.0);
        return new osg::Image(image(), osg::CopyOp::DEEP_COPY_ALL);
    }

    osg::ref_ptr<osg::Group> scene;
    osg::ref_ptr<Forest> forest;
    osg::Vec4 background{0, 0, 0, 1};
};

const osg::Vec4 sun(0.3f, -1.0f, 0.6f, 0.0f), white(0.4f, 0.4f, 0.4f, 1.0f);

} // namespace

TEST_F(SceneShadingGlTest, EveryEnabledLightCounts) {
    light(lightSource(0, sun, white));
    const osg::Vec3d one = meanColour(*picture());
    light(lightSource(3, sun, osg::Vec4(0.4f, 0, 0, 1)));
    const osg::Vec3d two = meanColour(*picture());
    EXPECT_GT(two.x(), 1.4 * one.x());
    EXPECT_NEAR(two.y(), one.y(), 1.0);
    scene->getStateSet()->setMode(GL_LIGHT3, osg::StateAttribute::OFF);
    EXPECT_NEAR(meanColour(*picture()).x(), one.x(), 0.5);
    scene->getStateSet()->setMode(GL_LIGHT0, osg::StateAttribute::OFF);
    scene->getStateSet()->setMode(GL_LIGHT3, osg::StateAttribute::ON);
    const osg::Vec3d red = meanColour(*picture());
    EXPECT_GT(red.x(), 2.0 * red.y());
}

TEST_F(SceneShadingGlTest, ColoursAreEncodedAsSrgb) {
    light(lightSource(0, sun, osg::Vec4(0.9f, 0.9f, 0.9f, 1.0f)));
    osg::ref_ptr<osg::Image> linear = picture();
    scene->getStateSet()->removeDefine("LINEAR_COLORS");
    scene->getStateSet()->setDefine("EXPOSURE", "1.0");
    osg::ref_ptr<osg::Image> encoded = picture();
    int pixels = 0;
    for (int i = 0; i < 4 * pictureSize * pictureSize; ++i) {
        const double value = encoded->data()[i] / 255.0;
        const double decoded = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
        if (i % 4 < 3) {
            ASSERT_NEAR(255.0 * decoded, linear->data()[i], 1.6) << "IEC 61966-2-1";
            pixels += linear->data()[i] > 8;
        }
    }
    EXPECT_GT(pixels, 1000);
    scene->getStateSet()->setMode(GL_FRAMEBUFFER_SRGB, osg::StateAttribute::ON);
    EXPECT_EQ(difference(*linear, *picture()).mean, 0.0) << "OpenGL encodes colours in an sRGB buffer only";
}

TEST_F(SceneShadingGlTest, SunlitLeavesAreAsBrightAsInAPhotographWithoutFilm) {
    light(lightSource(0, osg::Vec4(0.0f, -1.0f, 0.5f, 0.0f), osg::Vec4(0.8f, 0.8f, 0.8f, 1.0f)));
    scene->getStateSet()->removeDefine("LINEAR_COLORS");
    for (const char* name : {"oak", "European beech", "Scots pine"}) {
        scene->replaceChild(forest, new Forest(oneTree(*findSpecies(name), 0.0f)));
        forest = static_cast<Forest*>(scene->getChild(scene->getNumChildren() - 1));
        std::vector<double> bright;
        const osg::ref_ptr<osg::Image> drawn = picture(40.0, 2 * pictureSize, 0, 12.0);
        for (int i = 0; i < drawn->s() * drawn->t(); ++i)
            if (const unsigned char* p = drawn->data() + 4 * i; p[0] || p[1] || p[2])
                bright.push_back(luminance({p[0], p[1], p[2]}));
        std::sort(bright.begin(), bright.end());
        ASSERT_GT(bright.size(), 1000u);
        const double lit = bright[3 * bright.size() / 4]; // the median of the lit half
        EXPECT_GT(lit, 90.0) << name;
        EXPECT_LT(lit, 120.0) << name;
    }
}

TEST_F(SceneShadingGlTest, ExposureOfTheFileReplacesThatOfTheHost) {
    light(lightSource(0, sun, white));
    const osg::ref_ptr<osg::Image> plain = picture();
    scene->getStateSet()->setDefine("EXPOSURE", "2");
    const osg::Vec3d host = meanColour(*picture());
    EXPECT_NEAR(host.y(), 2.0 * meanColour(*plain).y(), 1.0);
    ForestDescription description = oneTree(smallSpecies(), 0.0f);
    description.drawing.exposure = 1.0f;
    scene->replaceChild(forest, new Forest(description));
    EXPECT_EQ(difference(*plain, *picture()).mean, 0.0);
}

TEST_F(SceneShadingGlTest, FilmCurveCompressesBrightColours) {
    light(lightSource(0, sun, osg::Vec4(0.9f, 0.9f, 0.9f, 1.0f)));
    const osg::ref_ptr<osg::Image> linear = picture();
    scene->getStateSet()->setDefine("FILM", "1.5");
    const osg::ref_ptr<osg::Image> filmed = picture();
    for (int i = 0; i < pictureSize * pictureSize; ++i) {
        const unsigned char *from = linear->data() + 4 * i, *to = filmed->data() + 4 * i;
        const double grey = luminance({from[0], from[1], from[2]});
        for (int channel = 0; channel < 3; ++channel) {
            const double c = 1.5 * (0.86 * from[channel] + 0.14 * grey) / 255.0;
            ASSERT_NEAR(to[channel], 255.0 * c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14), 4.0)
                << "Narkowicz 2016";
        }
    }
    scene->getStateSet()->setDefine("FILM", "1000.0");
    const osg::ref_ptr<osg::Image> bright = picture();
    EXPECT_LE(meanColour(*bright).y(), 255.0);
    EXPECT_GT(meanColour(*bright).y(), meanColour(*filmed).y());
}

TEST_F(SceneShadingGlTest, LeavesLetYellowLightThrough) {
    scene->replaceChild(forest, new Forest(oneTree(*findSpecies("beech"), 0.0f)));
    osg::ref_ptr<osg::LightModel> dark = new osg::LightModel;
    dark->setAmbientIntensity(osg::Vec4(0, 0, 0, 1));
    scene->getStateSet()->setAttribute(dark);
    osg::ref_ptr<osg::LightSource> source = lightSource(0, {}, osg::Vec4(4, 4, 4, 1));
    light(source);
    for (const double half : {6.0, 60.0}) { // with branches; impostor
        const auto litFrom = [&](double y) {
            source->getLight()->setPosition(osg::Vec4(0, y, 0.2f, 0));
            return meanColour(*picture(60.0, 2 * pictureSize, 0, half));
        };
        const osg::Vec3d front = litFrom(-1.0), behind = litFrom(1.0);
        EXPECT_GT(behind.y(), 0.35 * front.y()) << half;
        EXPECT_LT(behind.z() / behind.y(), 0.9 * front.z() / front.y()) << half;
    }
}

TEST_F(SceneShadingGlTest, CrownShadeTurnsWithTheTree) {
    osg::ref_ptr<osg::LightSource> source = lightSource(0, osg::Vec4(0, -1, 0.2f, 0), osg::Vec4(2, 2, 2, 1));
    light(source);
    osg::ref_ptr<osg::Image> one = picture(), turned;
    osg::ref_ptr<osg::MatrixTransform> turn = new osg::MatrixTransform(osg::Matrix::rotate(1.1, osg::Z_AXIS));
    ForestDescription description = oneTree(smallSpecies(), 0.0f);
    description.trees[0].heading = -1.1f;
    scene->removeChild(forest);
    scene->addChild(turn);
    turn->addChild(new Forest(description));
    turned = picture();
    EXPECT_LT(difference(*one, *turned).mean, 0.3);
    source->getLight()->setPosition(osg::Vec4(0, 1, 0.2f, 0)); // from behind
    EXPECT_GT(difference(*turned, *picture()).mean, 2.0);
}

namespace {

/// The means of the bytes of n x n pixels, like the multisample resolve of a window.
osg::ref_ptr<osg::Image> resolved(const osg::Image& fine, int n) {
    osg::ref_ptr<osg::Image> mean = new osg::Image;
    mean->allocateImage(fine.s() / n, fine.t() / n, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    for (int y = 0; y < mean->t(); ++y)
        for (int x = 0; x < mean->s(); ++x)
            for (int c = 0; c < 4; ++c) {
                int sum = 0;
                for (int i = 0; i < n * n; ++i)
                    sum += fine.data(n * x + i % n, n * y + i / n)[c];
                mean->data(x, y)[c] = static_cast<unsigned char>((sum + n * n / 2) / (n * n));
            }
    return mean;
}

} // namespace

TEST_F(SceneShadingGlTest, MultisamplingSmoothsLeafEdges) {
    scene->getStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    scene->getStateSet()->removeDefine("LINEAR_COLORS");
    const auto picture = [this](int pixels, int samples) {
        return this->picture(20.0, pixels, samples, 1.0);
    };
    osg::ref_ptr<osg::Image> mean = resolved(*picture(4 * pictureSize, 0), 4),
                             plain = picture(pictureSize, 0), multisampled = picture(pictureSize, 4);
    EXPECT_LT(difference(*multisampled, *mean).mean, 0.95 * difference(*plain, *mean).mean);
    for (int i = 3; i < 4 * pictureSize * pictureSize; i += 4)
        ASSERT_EQ(multisampled->data()[i], plain->data()[i]) << "multisampling does not change alpha";
}

TEST_F(SceneShadingGlTest, MultisampledCrownsAreAsDenseAsSupersampledOnes) {
    light(lightSource(0, sun, osg::Vec4(0.9f, 0.9f, 0.9f, 1.0f)));
    scene->getStateSet()->removeDefine("LINEAR_COLORS");
    scene->getStateSet()->setMode(GL_LIGHT0, osg::StateAttribute::ON);
    ForestDescription wood;
    for (const char* name : {"silver birch", "Norway spruce", "oak"})
        wood.species.push_back(*findSpecies(name));
    for (int i = 0; i < 6; ++i) { // in two rows
        TreePlacement tree;
        tree.species = static_cast<std::size_t>(i % 3);
        tree.position = {9.0 * (i % 3 - 1) + (i < 3 ? 0.0 : 4.5), i < 3 ? 0.0 : 8.0, -6.0};
        tree.size.height = 13.0f;
        tree.openGrown = true;
        tree.seed = static_cast<std::uint32_t>(i);
        wood.trees.push_back(tree);
    }
    scene->removeChild(forest);
    scene->addChild(new Forest(wood));
    background.set(1, 1, 1, 1);                     // shows through gaps
    for (const double half : {13.5, 30.0}) {        // with branches; impostors
        const int pixels = half < 20.0 ? 384 : 340; // 185 or 74 for a tree
        osg::ref_ptr<osg::Image> fine = resolved(*picture(60.0, 2 * pixels, 0, half, 2.0), 2),
                                 multisampled = picture(60.0, pixels, 4, half);
        for (int crown = 0; crown < 3; ++crown) {
            const auto place = [&](double metres) {
                return static_cast<int>((metres / half + 1.0) * pixels / 2.0);
            };
            const auto meanOf = [&](const osg::Image& image) {
                osg::Vec3d sum;
                int count = 0;
                for (int y = place(-5.0); y < place(4.0); ++y)
                    for (int x = place(9.0 * crown - 12.0); x < place(9.0 * crown - 6.0); ++x, ++count)
                        sum += osg::Vec3d(image.data(x, y)[0], image.data(x, y)[1], image.data(x, y)[2]);
                return sum / count;
            };
            const osg::Vec3d expected = meanOf(*fine), found = meanOf(*multisampled);
            EXPECT_LT(expected.y(), 200.0) << "there is no crown here";
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(found[c], expected[c], 3.0)
                    << wood.species[crown].name << ' ' << half << ' ' << c;
        }
    }
}

TEST_F(SceneShadingGlTest, OverrideAndProtectedModesWorkAsInOsg) {
    light(lightSource(0, sun, white));
    light(lightSource(1, sun, white));
    const osg::Vec3d both = meanColour(*picture());
    osg::StateSet& below = *forest->getOrCreateStateSet();
    below.setMode(GL_LIGHT1, osg::StateAttribute::OFF);
    const osg::Vec3d one = meanColour(*picture());
    EXPECT_LT(one.y(), 0.8 * both.y());
    scene->getStateSet()->setMode(GL_LIGHT1, osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
    EXPECT_NEAR(meanColour(*picture()).y(), both.y(), 0.5);
    below.setMode(GL_LIGHT1, osg::StateAttribute::OFF | osg::StateAttribute::PROTECTED);
    EXPECT_NEAR(meanColour(*picture()).y(), one.y(), 0.5);
}

TEST_F(SceneShadingGlTest, WithoutLightingNoLightCounts) {
    osg::ref_ptr<osg::LightSource> source = lightSource(0, sun, white);
    light(source);
    scene->getStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    osg::ref_ptr<osg::Image> one = picture();
    source->getLight()->setDiffuse(osg::Vec4(0, 0, 0, 1));
    EXPECT_EQ(difference(*one, *picture()).mean, 0.0);
    EXPECT_GT(meanColour(*one).y(), 30.0) << "unlit trees have their full colour";
}

TEST_F(SceneShadingGlTest, SpotlightHasConeExponentAndAttenuation) {
    osg::ref_ptr<osg::LightSource> source = lightSource(
        0, osg::Vec4(0, -30, 2.5f, 1), osg::Vec4(4, 4, 4, 1)); // bright, because 8 bits are coarse
    light(source);
    osg::Light& lamp = *source->getLight();
    const osg::Vec3d open = meanColour(*picture());
    lamp.setSpotCutoff(20.0f);
    lamp.setDirection(osg::Vec3(0, 1, 0));
    EXPECT_NEAR(meanColour(*picture()).y(), open.y(), 0.5);
    lamp.setDirection(osg::Vec3(1, 0, 0));
    const osg::Vec3d dark = meanColour(*picture());
    EXPECT_LT(dark.y(), 0.5 * open.y());
    lamp.setDirection(osg::Vec3(0, 1, 0));
    lamp.setSpotExponent(128.0f);
    EXPECT_LT(meanColour(*picture()).y(), 0.97 * open.y());
    lamp.setSpotExponent(0.0f);
    lamp.setSpotCutoff(180.0f);
    lamp.setConstantAttenuation(2.0f);
    const double half = 0.5 * (open.y() + dark.y());
    EXPECT_NEAR(meanColour(*picture()).y(), half, 0.03 * half);
    lamp.setConstantAttenuation(1.0f);
    lamp.setLinearAttenuation(1.0f / 30.0f);
    EXPECT_NEAR(meanColour(*picture()).y(), half, 0.05 * half);
}

TEST_F(SceneShadingGlTest, FogMatchesOpenGL) {
    light(lightSource(0, sun, white));
    scene->getStateSet()->removeDefine("LINEAR_COLORS"); // fog is mixed into encoded colours
    const double distance = 60.0;
    const osg::Vec3d clear = meanColour(*picture(distance)), colour(0.7, 0.75, 0.8);
    osg::ref_ptr<osg::Fog> fog = new osg::Fog;
    fog->setColor(osg::Vec4(0.7f, 0.75f, 0.8f, 1));
    fog->setDensity(0.015f);
    fog->setStart(20.0f);
    fog->setEnd(100.0f);
    scene->getStateSet()->setAttributeAndModes(fog);
    const struct {
        osg::Fog::Mode mode;
        double left;
    } cases[] = {{osg::Fog::LINEAR, 0.5},
                 {osg::Fog::EXP, std::exp(-0.015 * distance)},
                 {osg::Fog::EXP2, std::exp(-std::pow(0.015 * distance, 2.0))}};
    for (const auto& each : cases) {
        fog->setMode(each.mode);
        const osg::Vec3d found = meanColour(*picture(distance));
        const osg::Vec3d expected = clear * each.left + colour * (255.0 * (1.0 - each.left));
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], expected[c], 4.0) << each.mode;
    }
    forest->getOrCreateStateSet()->setMode(GL_FOG, osg::StateAttribute::OFF);
    EXPECT_NEAR(meanColour(*picture(distance)).y(), clear.y(), 0.5);
}

namespace {

enum Technique { Map, ViewDependent, TwoViewDependent };

/// The sun is in the east at an elevation of 45 degrees.
class ShadowsGlTest : public GlTest, public ::testing::WithParamInterface<Technique> {
protected:
    osg::ref_ptr<osgShadow::ShadowedScene> shadowedScene() {
        osg::ref_ptr<osgShadow::ShadowedScene> scene = new osgShadow::ShadowedScene;
        if (GetParam() == Map) {
            scene->setShadowTechnique(new osgShadow::ShadowMap);
        } else {
            scene->setShadowTechnique(new osgShadow::ViewDependentShadowMap);
            scene->getShadowSettings()->setNumShadowMapsPerLight(GetParam() == ViewDependent ? 1 : 2);
        }
        osg::ref_ptr<osg::LightSource> light =
            lightSource(0, osg::Vec4(1, 0, 1, 0), osg::Vec4(0.8f, 0.8f, 0.8f, 1));
        light->getLight()->setAmbient(osg::Vec4(0.2f, 0.2f, 0.2f, 1));
        scene->addChild(light);
        osg::StateSet& state = *scene->getOrCreateStateSet();
        state.setMode(GL_LIGHT0, osg::StateAttribute::ON);
        state.setMode(GL_LIGHTING, osg::StateAttribute::ON);
        state.setDefine("LINEAR_COLORS");
        state.setDefine("EXPOSURE", "4.0");
        return scene;
    }
    void look(osg::Node* scene, const osg::Vec3d& eye, const osg::Vec3d& centre, const osg::Vec3d& up,
              double half) {
        reopen(pictureSize, pictureSize);
        viewer().setSceneData(scene);
        viewer().setLightingMode(osg::View::NO_LIGHT);
        osg::Camera& camera = *viewer().getCamera();
        const double distance = (eye - centre).length();
        camera.setProjectionMatrixAsPerspective(2.0 * osg::RadiansToDegrees(std::atan(half / distance)), 1.0,
                                                1.0, 200.0);
        camera.setViewMatrixAsLookAt(eye, centre, up);
    }
    osg::ref_ptr<osg::Image> run(int first, int last) {
        for (int i = first; i <= last; ++i)
            frame(i / 25.0);
        return new osg::Image(image(), osg::CopyOp::DEEP_COPY_ALL);
    }
};

} // namespace

TEST_P(ShadowsGlTest, ShadowsFallOnTrees) {
    osg::Vec3d colours[2];
    for (const bool shaded : {false, true}) {
        osg::ref_ptr<osg::Group> scene = shadowedScene();
        scene->addChild(new Forest(oneTree(smallSpecies(), 0.0f)));
        // Between the sun and the tree, or beside it.
        osg::ref_ptr<osg::ShapeDrawable> cloud =
            new osg::ShapeDrawable(new osg::Box(osg::Vec3(20, shaded ? 0 : 40, 22), 14.0f, 14.0f, 14.0f));
        scene->addChild(cloud);
        look(scene, osg::Vec3d(0, -20, 2.5), osg::Vec3d(0, 0, 2.5), osg::Vec3d(0, 0, 1), 3.0);
        colours[shaded] = meanColour(*run(0, 2));
    }
    EXPECT_GT(colours[0].y(), 20.0);
    EXPECT_LT(colours[1].y(), 0.8 * colours[0].y());
    EXPECT_GT(colours[1].y(), 0.2 * colours[0].y()) << "the sky lights shaded trees";
}

TEST_P(ShadowsGlTest, ShadowsBlockTheSunButNotSkyAndLamps) {
    if (!hasFixedFunction && GetParam() == Map)
        GTEST_SKIP() << "the shaders of osgShadow::ShadowMap do not compile in a core profile";
    for (const double half : {3.0, 10.0}) { // with branches; impostor
        osg::ref_ptr<osg::Image> pictures[3];
        for (int i = 0; i < 3; ++i) { // without a sun; with it in shadow; with it
            const bool sunShines = i > 0, isShaded = i < 2;
            osg::ref_ptr<osgShadow::ShadowedScene> scene = shadowedScene();
            osg::Light& light = *static_cast<osg::LightSource*>(scene->getChild(0))->getLight();
            light.setAmbient(osg::Vec4(0, 0, 0, 1));
            if (auto* map = dynamic_cast<osgShadow::ShadowMap*>(scene->getShadowTechnique())) {
                map->setLight(&light);
                map->setAmbientBias(osg::Vec2(0.0f, 1.0f));
            }
            scene->getShadowSettings()->setLightNum(0);
            osg::ref_ptr<osg::LightModel> sky = new osg::LightModel;
            sky->setAmbientIntensity(osg::Vec4(0.6f, 0.6f, 0.6f, 1.0f));
            scene->getStateSet()->setAttribute(sky);
            scene->getStateSet()->setMode(GL_LIGHT1, osg::StateAttribute::ON);
            scene->addChild(lightSource(1, osg::Vec4(0, -1, 1, 0), osg::Vec4(0.3f, 0.2f, 0.1f, 1)));
            scene->addChild(new Forest(oneTree(smallSpecies(), 0.0f)));
            if (isShaded)
                scene->addChild(
                    new osg::ShapeDrawable(new osg::Box(osg::Vec3(20, 0, 22), 14.0f, 14.0f, 14.0f)));
            if (!sunShines)
                light.setDiffuse(osg::Vec4(0, 0, 0, 1));
            look(scene, osg::Vec3d(0, -20, 2.5), osg::Vec3d(0, 0, 2.5), osg::Vec3d(0, 0, 1), half);
            pictures[i] = run(0, 2);
        }
        const double sunless = meanColour(*pictures[0]).y(), sun = meanColour(*pictures[2]).y() - sunless;
        EXPECT_LT(meanColour(*pictures[1]).y() - sunless, 0.32 * sun)
            << "light from the ground and scattered in the crown: " << half;
        EXPECT_GT(sunless, 30.0) << half;
    }
}

TEST_P(ShadowsGlTest, TreeShadowsMoveOnTheGroundInWind) {
    if (!hasFixedFunction)
        GTEST_SKIP() << "OSG draws no shadows on shapes without a program in a core profile";
    osg::ref_ptr<osg::Group> scene = shadowedScene();
    osg::ref_ptr<Forest> forest = new Forest(oneTree(smallSpecies(), 15.0f));
    scene->addChild(forest);
    osg::ref_ptr<osg::ShapeDrawable> ground =
        new osg::ShapeDrawable(new osg::Box(osg::Vec3(0, 0, -0.5f), 40.0f, 40.0f, 1.0f));
    scene->addChild(ground);
    look(scene, osg::Vec3d(-4.5, 0, 30), osg::Vec3d(-4.5, 0, 0), osg::Vec3d(0, 1, 0), 2.0); // beside the tree
    forest->setNodeMask(0);
    osg::ref_ptr<osg::Image> bare = run(0, 1);
    forest->setNodeMask(~0u);
    osg::ref_ptr<osg::Image> first = run(2, 3), later = run(4, 40);
    EXPECT_GT(difference(*bare, *first).outliers, 0.02) << "no shadow";
    EXPECT_LT(meanColour(*first).y(), meanColour(*bare).y());
    EXPECT_GT(difference(*first, *later).outliers, 0.01) << "the shadow does not move";
}

TEST_P(ShadowsGlTest, PartsThatTheEyeDoesNotSeeCastShadows) {
    if (!hasFixedFunction)
        GTEST_SKIP() << "OSG draws no shadows on shapes without a program in a core profile";
    osg::ref_ptr<osg::Image> pictures[3];
    for (int i = 0; i < 3; ++i) { // without the tree; with it; with all of its parts drawn
        osg::ref_ptr<osg::Group> scene = shadowedScene();
        osg::ref_ptr<Forest> forest = new Forest(oneTree(smallSpecies(), 0.0f));
        forest->setNodeMask(i > 0 ? ~0u : 0u);
        scene->addChild(forest);
        scene->addChild(new osg::ShapeDrawable(new osg::Box(osg::Vec3(0, 0, -0.5f), 40.0f, 40.0f, 1.0f)));
        look(scene, osg::Vec3d(-4.5, 0, 30), osg::Vec3d(-4.5, 0, 0), osg::Vec3d(0, 1, 0), 2.0);
        osg::Camera& camera = *viewer().getCamera();
        camera.setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
        if (i == 2)
            camera.setCullingMode(osg::CullSettings::NO_CULLING);
        pictures[i] = run(0, 2);
    }
    EXPECT_GT(difference(*pictures[0], *pictures[1]).outliers, 0.02) << "no shadow";
    EXPECT_LT(difference(*pictures[1], *pictures[2]).outliers, 0.001);
}

TEST_P(ShadowsGlTest, ImpostorsCastShadowsOnTheGround) {
    if (!hasFixedFunction)
        GTEST_SKIP() << "OSG draws no shadows on shapes without a program in a core profile";
    osg::ref_ptr<osg::Group> scene = shadowedScene();
    ForestDescription description = oneTree(smallSpecies(), 0.0f);
    description.drawing.full = 6000.0f;
    description.drawing.reduced = 5000.0f;
    description.drawing.impostor = 4000.0f; // pixels: an impostor at any distance
    osg::ref_ptr<Forest> forest = new Forest(description);
    scene->addChild(forest);
    scene->addChild(new osg::ShapeDrawable(new osg::Box(osg::Vec3(0, 0, -0.5f), 40.0f, 40.0f, 1.0f)));
    look(scene, osg::Vec3d(-4.5, 0, 30), osg::Vec3d(-4.5, 0, 0), osg::Vec3d(0, 1, 0), 2.0); // beside the tree
    forest->setNodeMask(0);
    osg::ref_ptr<osg::Image> bare = run(0, 1);
    forest->setNodeMask(~0u);
    osg::ref_ptr<osg::Image> shaded = run(2, 3);
    EXPECT_GT(difference(*bare, *shaded).outliers, 0.02);
    EXPECT_LT(meanColour(*shaded).y(), meanColour(*bare).y());
}

INSTANTIATE_TEST_SUITE_P(Techniques, ShadowsGlTest, ::testing::Values(Map, ViewDependent, TwoViewDependent),
                         NamesInOrder({"ShadowMap", "ViewDependent", "TwoViewDependent"}));
