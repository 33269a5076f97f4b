// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/nodes/Pictures.h>

#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/offscreen/FrameImage.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <osg/ClipNode>
#include <osg/Fog>
#include <osg/GLExtensions>
#include <osg/LightSource>
#include <osg/MatrixTransform>
#include <osgShadow/ShadowMap>
#include <osgShadow/ShadowedScene>

#include <functional>

using namespace osgTreeWind;

namespace {

constexpr int width = 160, height = 120;

/// A viewer with a context of one profile.
class ProfileView {
public:
    ProfileView(ContextProfile profile, osg::Node* scene, int samples = 0)
        : _context(createOffscreenContext(width, height, profile).value()) {
        _viewer.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
        _image = attachFrameImage(*_viewer.getCamera(), *_context, samples);
        lookAtSmallForest(*_viewer.getCamera());
        _viewer.setSceneData(scene);
    }
    osg::Image& frame(double time) {
        _viewer.frame(time);
        return *_image;
    }
    osgViewer::Viewer& viewer() { return _viewer; }

private:
    osg::ref_ptr<osg::GraphicsContext> _context;
    osgViewer::Viewer _viewer;
    osg::ref_ptr<osg::Image> _image;
};

/// Mean difference of the pixels that are not black in `a`.
double differenceOnTrees(const osg::Image& a, const osg::Image& b) {
    EXPECT_GT(covered(a), 0.02);
    return difference(a, b).mean / covered(a);
}

ForestDescription forestUnder(MotionLaw law) {
    ForestDescription description = smallForest(8);
    description.law = law;
    return description;
}

/// A test that draws in both profiles. OSG itself complains about what it applies in the profile that it is
/// not built for, so its messages are not checked; ours are.
class CoreProfileGlTest : public GlTest, public ::testing::WithParamInterface<MotionLaw> {
protected:
    void SetUp() override { open(8, 8); }
    void TearDown() override {
        EXPECT_EQ(takeMessages().find("osgTreeWind"), std::string::npos);
        GlTest::TearDown();
    }

    /// Draws a scene with the forest in both profiles and compares the pictures.
    void expectSamePicture(const std::function<osg::ref_ptr<osg::Node>(Forest&)>& sceneOf, int samples = 0) {
        osg::ref_ptr<osg::Image> pictures[2];
        for (const ContextProfile profile : {ContextProfile::Compatibility, ContextProfile::Core}) {
            const osg::ref_ptr<Forest> forest = new Forest(forestUnder(GetParam()));
            ProfileView view(profile, sceneOf(*forest), samples);
            osg::ref_ptr<osg::Image>& picture = pictures[static_cast<int>(profile)];
            for (int i = 0; i < 3; ++i)
                picture = new osg::Image(view.frame(i / 25.0), osg::CopyOp::DEEP_COPY_ALL);
        }
        EXPECT_LT(differenceOnTrees(*pictures[0], *pictures[1]), 2.0);
    }
};

} // namespace

TEST_P(CoreProfileGlTest, OneForestInBothProfilesAtOnceInEitherOrder) {
    for (const bool coreFirst : {false, true}) {
        const osg::ref_ptr<Forest> forest = new Forest(forestUnder(GetParam()));
        ProfileView first(coreFirst ? ContextProfile::Core : ContextProfile::Compatibility, forest),
            second(coreFirst ? ContextProfile::Compatibility : ContextProfile::Core, forest);
        for (int i = 0; i < 3; ++i)
            EXPECT_LT(differenceOnTrees(first.frame(i / 25.0), second.frame(i / 25.0)), 2.0)
                << coreFirst << i;
    }
}

TEST_P(CoreProfileGlTest, TheLightOfTheViewLightsTrees) {
    expectSamePicture([](Forest& forest) { return &forest; });
}

TEST_P(CoreProfileGlTest, AttributesMayMoveToOtherLocations) { // as osgEarth's GL3RealizeOperation does
    const osg::ref_ptr<Forest> forest = new Forest(forestUnder(GetParam())), other = new Forest(*forest);
    ProfileView plain(ContextProfile::Core, forest), moved(ContextProfile::Core, other);
    moved.viewer().realize();
    osg::GraphicsContext& context = *moved.viewer().getCamera()->getGraphicsContext();
    ASSERT_TRUE(context.makeCurrent());
    context.getState()->initializeExtensionProcs();
    context.getState()->resetVertexAttributeAlias(false);
    context.getState()->setUseVertexAttributeAliasing(true);
    context.releaseContext();
    for (int i = 0; i < 2; ++i)
        EXPECT_EQ(difference(plain.frame(i / 25.0), moved.frame(i / 25.0)).mean, 0.0);
}

TEST_P(CoreProfileGlTest, SamplesAreCoveredAlike) {
    expectSamePicture([](Forest& forest) { return &forest; }, 4);
}

TEST_P(CoreProfileGlTest, AllTiersAreDrawnAlike) {
    expectSamePicture([](Forest&) {
        ForestDescription description = forestUnder(GetParam());
        description.drawing.full = 70.0f;
        description.drawing.reduced = 58.0f;
        description.drawing.impostor = 48.0f;
        return new Forest(description);
    });
}

TEST_P(CoreProfileGlTest, LampsFogAndClipPlanesAreThoseOfTheScene) {
    expectSamePicture([](Forest& forest) {
        osg::ref_ptr<osg::Group> root = new osg::Group;
        osg::StateSet* state = root->getOrCreateStateSet();
        for (int i = 0; i < 2; ++i) {
            osg::ref_ptr<osg::Light> light = new osg::Light(i);
            light->setPosition(i == 0 ? osg::Vec4(0.5f, -0.5f, 1.0f, 0.0f)
                                      : osg::Vec4(2.0f, -3.0f, 4.0f, 1.0f));
            light->setDiffuse(i == 0 ? osg::Vec4(0.9f, 0.8f, 0.5f, 1.0f) : osg::Vec4(0.2f, 0.3f, 2.0f, 1.0f));
            light->setDirection(osg::Vec3(0.0f, 1.0f, -0.2f));
            light->setSpotCutoff(i == 0 ? 180.0f : 40.0f);
            light->setLinearAttenuation(i == 0 ? 0.0f : 0.1f);
            osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
            source->setLight(light);
            source->setStateSetModes(*state, osg::StateAttribute::ON);
            root->addChild(source);
        }
        osg::ref_ptr<osg::Fog> fog = new osg::Fog;
        fog->setMode(osg::Fog::LINEAR);
        fog->setColor(osg::Vec4(0.9f, 0.4f, 0.4f, 1.0f));
        fog->setStart(5.0f);
        fog->setEnd(40.0f);
        state->setAttributeAndModes(fog);
        osg::ref_ptr<osg::ClipNode> clip = new osg::ClipNode;
        clip->addClipPlane(new osg::ClipPlane(1, 0.0, 0.0, -1.0, 4.5));
        clip->addChild(&forest);
        root->addChild(clip);
        return root;
    });
}

TEST_P(CoreProfileGlTest, ForestsMayHaveDifferentFog) {
    expectSamePicture([](Forest& forest) {
        osg::ref_ptr<osg::Group> root = new osg::Group;
        for (const bool isSecond : {false, true}) {
            osg::ref_ptr<osg::Fog> fog = new osg::Fog;
            fog->setMode(osg::Fog::LINEAR);
            fog->setColor(isSecond ? osg::Vec4(0.2f, 0.3f, 0.9f, 1.0f) : osg::Vec4(0.9f, 0.4f, 0.4f, 1.0f));
            fog->setEnd(30.0f);
            osg::ref_ptr<osg::MatrixTransform> place =
                new osg::MatrixTransform(osg::Matrix::translate(isSecond ? 1.5 : 0.0, 0.0, 0.0));
            place->getOrCreateStateSet()->setAttributeAndModes(fog);
            place->addChild(isSecond ? new Forest(forest) : &forest);
            root->addChild(place);
        }
        return root;
    });
}

TEST_P(CoreProfileGlTest, ShadowsFallOnTrees) {
    expectSamePicture([](Forest& forest) {
        osg::ref_ptr<osgShadow::ShadowMap> technique = new osgShadow::ShadowMap;
        technique->setTextureUnit(2);
        osg::ref_ptr<osgShadow::ShadowedScene> scene = new osgShadow::ShadowedScene(technique);
        osg::ref_ptr<osg::LightSource> sun = new osg::LightSource;
        sun->getLight()->setPosition(osg::Vec4(0.7f, -0.4f, 1.0f, 0.0f));
        scene->addChild(sun);
        forest.setNodeMask(3);
        scene->addChild(&forest);
        return scene;
    });
}

INSTANTIATE_TEST_SUITE_P(Laws, CoreProfileGlTest,
                         ::testing::Values(MotionLaw::Modal, MotionLaw::ThesisSmooth),
                         [](const auto& law) { return law.param == MotionLaw::Modal ? "Modal" : "Thesis"; });

TEST_F(GlTest, HostsSetTheLightsOfACoreProfile) {
    open(8, 8);
    const osg::ref_ptr<Forest> forest = new Forest(smallForest(8));
    ProfileView view(ContextProfile::Core, forest);
    const auto redAndBlue = [&](const osg::Vec4& diffuse) {
        osg::StateSet* state = view.viewer().getCamera()->getOrCreateStateSet();
        state->getOrCreateUniform("osg_LightSource[0].position", osg::Uniform::FLOAT_VEC4)
            ->set(osg::Vec4(0.0f, 0.3f, 1.0f, 0.0f));
        state->getOrCreateUniform("osg_LightSource[0].diffuse", osg::Uniform::FLOAT_VEC4)->set(diffuse);
        const osg::Image& image = view.frame(0.0);
        double red = 0.0, blue = 0.0;
        for (int i = 0; i < width * height; ++i) {
            red += image.data()[4 * i];
            blue += image.data()[4 * i + 2];
        }
        return red / blue;
    };
    EXPECT_GT(redAndBlue({1.0f, 0.0f, 0.0f, 1.0f}), 3.0 * redAndBlue({0.0f, 0.0f, 1.0f, 1.0f}));
    takeMessages();
}
