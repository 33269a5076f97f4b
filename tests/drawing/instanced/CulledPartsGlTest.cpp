// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/nodes/Pictures.h>

#include <osgTreeWind/drawing/instanced/InstancedForest.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>

#include <osg/GLExtensions>

#include <cstdlib>
#include <vector>

using namespace osgTreeWind;

namespace {

constexpr int pictureWidth = 320, pictureHeight = 240;

/// A part of a picture, in pixels from the lower left corner.
struct Rectangle {
    int x, y, width, height;
};
constexpr Rectangle whole{0, 0, pictureWidth, pictureHeight};

/// One tree of the catalogue, 12 m tall, whose picture nearly fills the view.
ForestDescription tree(const char* species, float wind, bool tiers = false) {
    ForestDescription description = oneTree(*findSpecies(species), wind);
    description.species.front().shapes = 1;
    description.trees.front().size.height = 12.0f;
    description.trees.front().size.crownWidth = 8.0f;
    description.trees.front().heading = 0.8f;
    description.drawing.tiers = tiers;
    return description;
}

/// Rows of spruces whose crowns begin at the ground, from 6 m north of the origin on.
ForestDescription thicket() {
    ForestDescription description = smallForest(0, 5.0f);
    description.species = {*findSpecies("Norway spruce")};
    description.species.front().shapes = 1;
    description.drawing.full = 40.0f;
    description.drawing.reduced = 20.0f;
    description.drawing.impostor = 10.0f;
    for (int i = 0; i < 63; ++i) {
        TreePlacement tree;
        tree.position = {1.5 * (i % 9) - 6.0, 6.0 + 3.0 * (i / 9), 0.0};
        tree.heading = 2.1f * static_cast<float>(i);
        tree.size.height = 7.0f + static_cast<float>(i % 4);
        tree.openGrown = true;
        tree.seed = static_cast<std::uint32_t>(i);
        description.trees.push_back(tree);
    }
    return description;
}

/// Counts the triangles that a camera draws.
class TriangleCount : public osg::Camera::DrawCallback {
public:
    void operator()(osg::RenderInfo& renderInfo) const override {
        const osg::GLExtensions& gl = *renderInfo.getState()->get<osg::GLExtensions>();
        if (_query == 0) { // before the draws
            gl.glGenQueries(1, &_query);
            gl.glBeginQuery(GL_PRIMITIVES_GENERATED, _query);
            return;
        }
        gl.glEndQuery(GL_PRIMITIVES_GENERATED);
        gl.glGetQueryObjectuiv(_query, GL_QUERY_RESULT, &triangles);
        gl.glDeleteQueries(1, &_query);
        _query = 0;
    }
    mutable GLuint triangles = 0; ///< In the last frame.

private:
    mutable GLuint _query = 0;
};

class CulledPartsGlTest : public GlTest {
protected:
    /// Draws five frames of what a camera sees within a rectangle of its view.
    osg::ref_ptr<osg::Image> picture(osg::Node* scene, const Rectangle& seen = whole, bool indirect = true) {
        open(pictureWidth, pictureHeight);
        viewer().setSceneData(scene);
        look(*viewer().getCamera(), seen);
        osg::ref_ptr<TriangleCount> count = new TriangleCount;
        viewer().getCamera()->setPreDrawCallback(count);
        viewer().getCamera()->setPostDrawCallback(count);
        frame(0.0);
        auto& draw = context().getState()->get<osg::GLExtensions>()->glMultiDrawElementsIndirect;
        const auto function = draw;
        draw = indirect ? function : nullptr;
        for (int i = 1; i < 5; ++i)
            frame(i / 25.0);
        draw = function;
        triangles = count->triangles;
        return new osg::Image(image(), osg::CopyOp::DEEP_COPY_ALL);
    }
    void look(osg::Camera& camera, const Rectangle& seen) const {
        camera.setClearColor(osg::Vec4(0, 0, 0, 1));
        camera.setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
        camera.setLODScale(lodScale);
        camera.setViewMatrixAsLookAt(eye, centre, osg::Z_AXIS);
        camera.setViewport(seen.x, seen.y, seen.width, seen.height);
        const double wide = double(pictureWidth) / seen.width, high = double(pictureHeight) / seen.height;
        camera.setProjectionMatrix(
            osg::Matrix::perspective(45.0, double(pictureWidth) / pictureHeight, 0.5, 200.0) *
            osg::Matrix::scale(wide, high, 1.0) *
            osg::Matrix::translate((pictureWidth - 2.0 * seen.x) / seen.width - 1.0,
                                   (pictureHeight - 2.0 * seen.y) / seen.height - 1.0, 0.0));
    }

    /// Adds a camera that draws what this one sees within a rectangle of its view. @return its picture.
    osg::ref_ptr<osg::Image> addCamera(osg::Group& scene, osg::Node* drawn, const Rectangle& seen) const {
        osg::ref_ptr<osg::Camera> camera = new osg::Camera;
        look(*camera, seen);
        camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
        camera->setRenderOrder(osg::Camera::PRE_RENDER);
        camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
        osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(pictureWidth, pictureHeight, 1, GL_RGBA, GL_UNSIGNED_BYTE);
        camera->attach(osg::Camera::COLOR_BUFFER, image);
        camera->addChild(drawn);
        scene.addChild(camera);
        return image;
    }

    osg::Vec3 eye{0, -16, 5}, centre{0, 0, 6};
    float lodScale = 1.0f;
    GLuint triangles = 0; ///< Of the last frame.
};

/// Share of the pixels of a picture that differ by more than 2 in a colour from those of a rectangle of
/// another.
double unlike(const osg::Image& detail, const osg::Image& wide, const Rectangle& at = whole) {
    EXPECT_EQ(detail.s(), at.width);
    EXPECT_EQ(detail.t(), at.height);
    int pixels = 0;
    for (int y = 0; y < at.height; ++y)
        for (int x = 0; x < at.width; ++x) {
            bool differs = false;
            for (int c = 0; c < 3; ++c)
                differs = differs ||
                          std::abs(int(detail.data(x, y)[c]) - int(wide.data(at.x + x, at.y + y)[c])) > 2;
            pixels += differs;
        }
    return pixels / double(at.width * at.height);
}

struct Detail {
    const char* name;
    Rectangle pixels;
};
const Detail details[] = {{"trunk", {140, 30, 40, 40}},
                          {"crown", {60, 110, 200, 130}},
                          {"bough", {170, 120, 24, 16}},
                          {"edge", {0, 0, 130, 240}}};

} // namespace

TEST_F(CulledPartsGlTest, DetailsOfATreeAreDrawnAsInAWiderView) {
    const struct Case {
        ForestDescription forest;
        float lodScale;
    } cases[] = {{tree("oak", 0.0f, true), 1.0f},
                 {tree("Norway spruce", 20.0f, false), 1.0f}, // sways into the view
                 {tree("oak", 20.0f, true), 3.0f}};
    for (const Case& each : cases) {
        lodScale = each.lodScale;
        const osg::ref_ptr<osg::Image> wide = picture(new Forest(each.forest));
        const GLuint all = triangles;
        for (const Detail& detail : details) {
            const osg::ref_ptr<osg::Image> picture =
                CulledPartsGlTest::picture(new Forest(each.forest), detail.pixels);
            EXPECT_GT(covered(*picture), 0.01) << detail.name;
            EXPECT_LT(unlike(*picture, *wide, detail.pixels), 0.002) << detail.name;
            EXPECT_LT(triangles, all) << detail.name;
        }
    }
}

TEST_F(CulledPartsGlTest, AThicketLooksAsIfNothingWereHidden) {
    eye = {0, 0, 1.7f};
    const ForestDescription description = thicket();
    for (const osg::Vec3& at : {osg::Vec3(0, 20, 3), osg::Vec3(3, 20, 6), osg::Vec3(-8, 20, 1)}) {
        centre = at;
        const osg::ref_ptr<Forest> all = new Forest(description);
        instancedTrees(*all->getInstanced()).setDrawsHiddenParts(true);
        const osg::ref_ptr<osg::Image> expected = picture(all);
        const GLuint trianglesOfAll = triangles;
        const osg::ref_ptr<osg::Image> fewer = picture(new Forest(description));
        EXPECT_GT(covered(*expected), 0.6);
        EXPECT_LT(difference(*fewer, *expected).mean, 0.3);
        EXPECT_LT(difference(*fewer, *expected).outliers, 0.006);
        EXPECT_LT(triangles, 0.95 * trianglesOfAll) << "the test hides nothing";
    }
}

TEST_F(CulledPartsGlTest, WithoutIndirectDrawsTheSameIsDrawn) {
    eye = {0, 0, 1.7f};
    centre = {3, 20, 2};
    const ForestDescription description = thicket();
    const osg::ref_ptr<osg::Image> indirect = picture(new Forest(description)),
                                   direct = picture(new Forest(description), whole, false);
    EXPECT_GT(covered(*indirect), 0.7);
    EXPECT_EQ(difference(*indirect, *direct).mean, 0.0);
}

TEST_F(CulledPartsGlTest, CamerasOfOneFrameDrawWhatTheyDrawAlone) {
    const ForestDescription description = tree("oak", 10.0f, true);
    const auto pictures = [&](std::vector<std::size_t> chosen) {
        osg::ref_ptr<osg::Group> scene = new osg::Group;
        osg::ref_ptr<Forest> forest = new Forest(description);
        std::vector<osg::ref_ptr<osg::Image>> images;
        for (const std::size_t i : chosen)
            images.push_back(addCamera(*scene, forest, details[i].pixels));
        picture(scene);
        return images;
    };
    const auto together = pictures({0, 1, 2, 3});
    for (std::size_t i = 0; i < together.size(); ++i) {
        const osg::ref_ptr<osg::Image> alone = pictures({i}).front();
        EXPECT_GT(covered(*together[i]), 0.01) << details[i].name;
        EXPECT_EQ(difference(*together[i], *alone).mean, 0.0) << details[i].name;
    }
}

TEST_F(CulledPartsGlTest, ALaterCameraDrawsATreeWhereItIs) { // in buffers that reuse the names of others
    ForestDescription description = tree("oak", 0.0f, true);
    osg::ref_ptr<Forest> forest = new Forest(description);
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    addCamera(*scene, forest, details[1].pixels);
    picture(scene);
    scene->removeChildren(0, 1);
    scene->addChild(forest);
    viewer().getCamera()->setCullMask(0);
    for (int i = 5; i < 80; ++i)
        frame(i / 25.0);
    scene->removeChildren(0, 1);
    viewer().getCamera()->setCullMask(~0u);
    description.trees.front().position.x += 2.0;
    ASSERT_TRUE(forest->changeTree(TreeId(0), description.trees.front()).empty());
    const osg::ref_ptr<osg::Image> later = addCamera(*scene, forest, details[1].pixels);
    for (int i = 80; i < 83; ++i)
        frame(i / 25.0);
    scene->removeChildren(0, 1);
    const osg::ref_ptr<osg::Image> expected = addCamera(*scene, new Forest(description), details[1].pixels);
    picture(scene);
    EXPECT_GT(covered(*later), 0.01);
    EXPECT_EQ(difference(*later, *expected).mean, 0.0);
}
