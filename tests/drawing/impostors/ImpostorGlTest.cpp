// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/nodes/Pictures.h>

#include <osgTreeWind/drawing/impostors/ImpostorStrip.h>
#include <osgTreeWind/drawing/looks/SceneUniforms.h>
#include <osgTreeWind/gpu/OpenGLProfile.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/MovingForest.h>

#include <osg/GLExtensions>

#include <cmath>

using namespace osgTreeWind;

namespace {

constexpr int size = 128; // pixels

/// Vertex attributes of an instance.
struct Instance : osg::Drawable::DrawCallback {
    osg::Vec4 place{0, 0, 0, 0}, scale{1, 1, 0, 0}, state{0, 0, 1, 0};

    void drawImplementation(osg::RenderInfo& info, const osg::Drawable* drawable) const override {
        osg::GLExtensions* gl = info.getState()->get<osg::GLExtensions>();
        gl->glVertexAttrib4fv(treePlaceLocation, place.ptr());
        gl->glVertexAttrib4fv(treeSizeLocation, scale.ptr());
        gl->glVertexAttrib4fv(treeStateLocation, state.ptr());
        gl->glVertexAttrib4f(treeLightLocation, 1.0f, 1.0f, 0.0f, 0.0f);
        if (isCoreProfile(*info.getState()))
            applySceneUniforms(info);
        drawable->drawImplementation(info);
    }
};

/// Direction to the camera in degrees, and height of the tree on the screen.
struct Sight {
    double azimuth, elevation, pixels;
};

Species speciesCalled(const std::string& name) {
    return name == "thesis" ? Species() : *findSpecies(name);
}

/// A forest that is drawn in full at any size.
osg::ref_ptr<Forest> inFull(ForestDescription description) {
    description.drawing.tiers = false;
    return new Forest(description);
}

/// Mean difference of the colours of 8 x 8 pixel blocks that are not black in both pictures.
double blockDifference(const osg::Image& a, const osg::Image& b) {
    double sum = 0.0;
    int blocks = 0;
    for (int y = 0; y < size; y += 8)
        for (int x = 0; x < size; x += 8) {
            double difference[3] = {0, 0, 0}, total = 0.0;
            for (int i = 0; i < 64; ++i)
                for (int c = 0; c < 3; ++c) {
                    const int one = *(a.data(x + i % 8, y + i / 8) + c),
                              other = *(b.data(x + i % 8, y + i / 8) + c);
                    difference[c] += (one - other) / 64.0;
                    total += one + other;
                }
            if (total == 0.0)
                continue;
            ++blocks;
            for (const double d : difference)
                sum += std::abs(d) / 3.0;
        }
    return sum / blocks;
}

class ImpostorGlTest : public GlTest {
protected:
    osg::ref_ptr<osg::Image> picture(osg::Node* node, const Sight& sight, float height) {
        reopen(size, size);
        node->getOrCreateStateSet()->setDefine("EXPOSURE", "1.0"); // that of the bounds below
        viewer().setSceneData(node);
        viewer().setLightingMode(osg::View::SKY_LIGHT);
        viewer().getLight()->setPosition(osg::Vec4(0.5f, -0.7f, 0.8f, 0.0f));
        osg::Camera& camera = *viewer().getCamera();
        const double a = osg::DegreesToRadians(sight.azimuth), e = osg::DegreesToRadians(sight.elevation);
        const osg::Vec3d middle(0, 0, 0.5 * height), to(cos(a) * cos(e), sin(a) * cos(e), sin(e));
        const double distance = 0.5 * size / sight.pixels * height / tan(osg::DegreesToRadians(15.0));
        camera.setClearColor(osg::Vec4(0, 0, 0, 1));
        camera.setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
        camera.setProjectionMatrixAsPerspective(30, 1, 0.1 * distance, 3 * distance);
        camera.setViewMatrixAsLookAt(middle + to * distance, middle, osg::Z_AXIS);
        frame(0.0);
        return new osg::Image(image(), osg::CopyOp::DEEP_COPY_ALL);
    }

    osg::ref_ptr<ImpostorStrip> shapeOf(const Species& species, const ImpostorSettings& settings = {}) {
        const TreeModel model = makeTreeModel(species.tree);
        return new ImpostorStrip(paintImpostor(model, species.appearance, settings),
                                 sharedProgram("impostor", "impostor"));
    }

    osg::ref_ptr<osg::Node> impostor(ImpostorStrip& shape, Instance* instance) {
        return impostor(shape, *shape.geometry(), instance);
    }
    osg::ref_ptr<osg::Node> impostor(ImpostorStrip& shape, const osg::Geometry& strip, Instance* instance) {
        osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry(strip);
        geometry->setDrawCallback(instance);
        geometry->setCullingActive(false);
        osg::ref_ptr<osg::Group> group = new osg::Group;
        group->addChild(geometry);
        group->setCullingActive(false);
        group->setStateSet(new osg::StateSet(*shape.stateSet()));
        group->getStateSet()->setDefine("FADING");
        group->getStateSet()->addUniform(new osg::Uniform("leanPower", 1.5f));
        return group;
    }
};

} // namespace

TEST_F(ImpostorGlTest, LooksLikeTheTreeDrawnInFull) {
    for (const char* name : {"thesis", "oak", "birch", "Norway spruce", "Scots pine", "larch"}) {
        const Species species = speciesCalled(name);
        osg::ref_ptr<ImpostorStrip> shape = shapeOf(species);
        osg::ref_ptr<osg::Node> flat = impostor(*shape, new Instance), full = inFull(oneTree(species, 0.0f));
        for (const double pixels : {25.0, 50.0}) {
            double blocks = 0.0, areas[2] = {0.0, 0.0};
            const double sights[][2] = {{0, 0}, {22.5, 0}, {100, 15}, {200, 30}, {300, 45}};
            for (const auto& [azimuth, elevation] : sights) {
                const Sight sight{azimuth, elevation, pixels};
                osg::ref_ptr<osg::Image> a = picture(full, sight, shape->pictures().height),
                                         b = picture(flat, sight, shape->pictures().height);
                blocks += blockDifference(*a, *b) / 5.0;
                areas[0] += covered(*a);
                areas[1] += covered(*b);
            }
            EXPECT_LT(blocks, 4.0) << name << ", " << pixels;
            EXPECT_NEAR(areas[1] / areas[0], 1.0, pixels < 50.0 ? 0.11 : 0.06) << name << ", " << pixels;
        }
    }
}

namespace {

/// Centroid of the pixels that are not black, relative to the middle of the picture.
osg::Vec2d middleOf(const osg::Image& image, int fromRow) {
    osg::Vec2d sum;
    double count = 0.0;
    for (int y = fromRow; y < size; ++y)
        for (int x = 0; x < size; ++x)
            if (image.data(x, y)[1] > 0) {
                sum += osg::Vec2d(x, y);
                ++count;
            }
    return sum / count - osg::Vec2d(size / 2, size / 2);
}

} // namespace

TEST_F(ImpostorGlTest, LeansAtTheTopAndNotAtTheFoot) {
    osg::ref_ptr<ImpostorStrip> shape = shapeOf(Species());
    const float height = shape->pictures().height;
    const Sight sight{-90.0, 0.0, 80.0}; // from the south: +x is to the right
    osg::ref_ptr<Instance> still = new Instance, leaning = new Instance;
    leaning->state = osg::Vec4(0.15f * height, 0.0f, 1.0f, 0.0f);
    osg::ref_ptr<osg::Image> a = picture(impostor(*shape, still), sight, height),
                             b = picture(impostor(*shape, leaning), sight, height);
    const int top = size / 2 + 36; // the tree extends 40 pixels up and down
    EXPECT_NEAR(middleOf(*b, top).x() - middleOf(*a, top).x(), 0.15 * 80.0, 2.0);
    const auto foot = [](const osg::Image& image) { // mean x of the trunk just above the ground
        double sum = 0.0, count = 0.0;
        for (int y = size / 2 - 39; y < size / 2 - 35; ++y)
            for (int x = 0; x < size; ++x)
                if (image.data(x, y)[1] > 0) {
                    sum += x;
                    ++count;
                }
        return sum / count;
    };
    EXPECT_NEAR(foot(*b), foot(*a), 1.0);
}

TEST_F(ImpostorGlTest, AStrongLeanKeepsTheLengthOfTheStem) {
    osg::ref_ptr<ImpostorStrip> shape = shapeOf(Species());
    const float height = shape->pictures().height;
    osg::ref_ptr<Instance> leaning = new Instance;
    leaning->state = osg::Vec4(0.6f * height, 0.0f, 1.0f, 0.0f);
    osg::ref_ptr<osg::Image> image = picture(impostor(*shape, leaning), {-90.0, 0.0, 80.0}, height);
    int top = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            if (image->data(x, y)[1] > 0)
                top = y;
    EXPECT_NEAR(top - (size / 2 - 40), 0.8 * 80.0, 3.0) << "3, 4, 5";
}

TEST_F(ImpostorGlTest, BendOfASmallTreeIsLessThanAPixel) {
    osg::ref_ptr<ImpostorStrip> shape = shapeOf(Species());
    const float height = shape->pictures().height;
    osg::ref_ptr<Instance> leaning = new Instance;
    leaning->state = osg::Vec4(0.15f * height, 0.0f, 1.0f, 0.0f);
    const Sight sight{-90.0, 0.0, static_cast<double>(ImpostorStrip::bendingPixels)};
    osg::ref_ptr<osg::Image> bent = picture(impostor(*shape, leaning), sight, height),
                             straight = picture(impostor(*shape, *shape->straightGeometry(), leaning), sight,
                                                height);
    EXPECT_EQ(shape->straightGeometry()->getVertexArray()->getNumElements(), 4u);
    EXPECT_NEAR(covered(*straight) / covered(*bent), 1.0, 0.05);
    for (int y = size / 2 - 8; y < size / 2 + 8; y += 4)
        EXPECT_NEAR(middleOf(*straight, y).x(), middleOf(*bent, y).x(), 1.0) << y;
}

TEST_F(ImpostorGlTest, TwoPartsOfAFadeAddUp) {
    osg::ref_ptr<ImpostorStrip> shape = shapeOf(Species());
    const Sight sight{30.0, 20.0, 80.0};
    osg::ref_ptr<osg::Image> parts[3];
    const float fades[] = {1.0f, 0.3f, -0.3f};
    for (int i = 0; i < 3; ++i) {
        osg::ref_ptr<Instance> instance = new Instance;
        instance->state.z() = fades[i];
        parts[i] = picture(impostor(*shape, instance), sight, shape->pictures().height);
    }
    for (int i = 0; i < 4 * size * size; ++i)
        if (i % 4 < 3) {
            ASSERT_EQ(parts[0]->data()[i], parts[1]->data()[i] + parts[2]->data()[i]) << i;
        }
    EXPECT_NEAR(covered(*parts[1]) / covered(*parts[0]), 0.3, 0.03);
}

TEST_F(ImpostorGlTest, HasHeadingAndSizeOfTheTree) {
    const Species species = speciesCalled("thesis"); // its trees have the same shape at all sizes
    osg::ref_ptr<ImpostorStrip> shape = shapeOf(species);
    ForestDescription turned = oneTree(species, 0.0f);
    turned.trees[0].heading = 1.1f;
    turned.trees[0].size.height = 20.0f;
    turned.trees[0].size.crownWidth = 8.0f;
    osg::ref_ptr<Forest> forest = inFull(turned);
    const TreeScale& scale = movingForest(forest->getSimulation()).trees()[0].scale;
    osg::ref_ptr<Instance> instance = new Instance;
    instance->place.w() = 1.1f;
    instance->scale = osg::Vec4(scale.axes.x, scale.axes.z, 0.0f, 0.0f);
    for (const double elevation : {0.0, 40.0}) {
        const Sight sight{50.0, elevation, 50.0};
        osg::ref_ptr<osg::Image> a = picture(forest, sight, 20.0f),
                                 b = picture(impostor(*shape, instance), sight, 20.0f);
        EXPECT_LT(blockDifference(*a, *b), 4.0) << elevation;
        EXPECT_NEAR(covered(*b) / covered(*a), 1.0, 0.18) << elevation;
    }
}

TEST_F(ImpostorGlTest, ParallelCameraSeesTheSameTree) {
    osg::ref_ptr<ImpostorStrip> shape = shapeOf(Species());
    const float height = shape->pictures().height;
    osg::ref_ptr<osg::Node> flat = impostor(*shape, new Instance), full = inFull(oneTree(Species(), 0.0f));
    osg::ref_ptr<osg::Image> pictures[2];
    for (int i = 0; i < 2; ++i) {
        picture(i ? full : flat, {70.0, 75.0, 50.0}, height); // like the camera of a high sun
        const double half = 0.5 * height * size / 50.0;
        viewer().getCamera()->setProjectionMatrixAsOrtho(-half, half, -half, half, 1.0, 1000.0);
        frame(0.0);
        pictures[i] = new osg::Image(image(), osg::CopyOp::DEEP_COPY_ALL);
    }
    EXPECT_LT(blockDifference(*pictures[0], *pictures[1]), 6.0);
    EXPECT_NEAR(covered(*pictures[0]) / covered(*pictures[1]), 1.0, 0.1);
}
