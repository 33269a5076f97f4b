// SPDX-License-Identifier: MIT
// Replaces shaders/surface.glsl by the files of examples/surface.
#include <tests/Folders.h>
#include <tests/gl/GlTest.h>
#include <tests/gpu/FilePath.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/nodes/Pictures.h>

#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osg/Geometry>
#include <osg/Texture2D>

#include <set>

using namespace osgTreeWind;

namespace {

enum class Way { Modal, Branchwise };

class SurfaceGlTest : public GlTest, public ::testing::WithParamInterface<Way> {
protected:
    static constexpr int width = 200, height = 150;

    /// Trees in a row along x, some of them impostors.
    static osg::ref_ptr<Forest> forest() {
        ForestDescription description = smallForest(4);
        if (GetParam() == Way::Branchwise)
            description.law = MotionLaw::ThesisSmooth;
        description.drawing.impostor = 60.0f;
        for (std::size_t i = 0; i < description.trees.size(); ++i)
            description.trees[i].seed = 1000 * static_cast<std::uint32_t>(i);
        description.trees[3].size.height = 2.0f;
        return new Forest(description);
    }
    static FilePath replaced(const std::string& example) {
        return FilePath(OSGTREEWIND_SOURCE_DIR "/examples/surface/" + example);
    }
    void look() {
        open(width, height);
        osg::Camera& camera = *viewer().getCamera();
        camera.setClearColor(osg::Vec4(0, 0, 0, 1));
        camera.setProjectionMatrixAsPerspective(40, double(width) / height, 1, 100);
        camera.setViewMatrixAsLookAt(osg::Vec3(4.5f, -18, 4), osg::Vec3(4.5f, 0, 3), osg::Z_AXIS);
    }
    osg::ref_ptr<osg::Image> picture(osg::Node* scene) {
        look();
        viewer().setSceneData(scene);
        for (int i = 0; i < 10; ++i)
            frame(i / 25.0);
        return new osg::Image(image(), osg::CopyOp::DEEP_COPY_ALL);
    }
};

/// An upright wall from `left` to `right` along x.
osg::ref_ptr<osg::Node> wall(float left, float right, float y) {
    osg::ref_ptr<osg::Geometry> geometry = osg::createTexturedQuadGeometry(
        osg::Vec3(left, y, 0), osg::Vec3(right - left, 0, 0), osg::Vec3(0, 0, 8));
    return geometry;
}

/// A wall in front of the trees on the left, and a wall behind the trees on the right.
osg::ref_ptr<osg::Group> scene(Forest* forest, const std::string& vertexEnd, const std::string& fragmentEnd) {
    osg::ref_ptr<osg::Group> walls = new osg::Group;
    walls->addChild(wall(-2, 2, -5));
    walls->addChild(wall(4, 12, 6));
    walls->getOrCreateStateSet()->setAttributeAndModes(makeProgram(
        "walls",
        "out float far;\nvoid main() { gl_Position = osg_ProjectionMatrix * osg_ModelViewMatrix * "
        "osg_Vertex; " +
            vertexEnd + " }",
        "uniform float farthest;\nin float far;\nout vec4 color;\nvoid main() { "
        "color = vec4(0.2, 0.2, 0.9, 1.0); " +
            fragmentEnd + " }"));
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(walls);
    root->addChild(forest);
    root->getOrCreateStateSet()->addUniform(new osg::Uniform("farthest", 1.0e7f));
    return root;
}

} // namespace

TEST_P(SurfaceGlTest, LogarithmicDepthHidesTheSamePixels) {
    const osg::ref_ptr<osg::Image> expected = picture(scene(forest(), "far = 0.0;", ""));
    const FilePath path = replaced("logarithmic_depth");
    const osg::ref_ptr<osg::Image> found = picture(
        scene(forest(), "far = gl_Position.w;", "gl_FragDepth = log2(1.0 + far) / log2(1.0 + farthest);"));
    EXPECT_LT(difference(*found, *expected).outliers, 0.001);
    EXPECT_GT(covered(*expected), 0.2);
}

TEST_P(SurfaceGlTest, GBufferHasUnlitAlbedoAndNormals) {
    const FilePath path = replaced("g_buffer");
    const auto drawn = [&](osg::View::LightingMode lighting) {
        const osg::ref_ptr<osg::Image> albedo = new osg::Image, normals = new osg::Image;
        albedo->allocateImage(width, height, 1, GL_RGBA, GL_UNSIGNED_BYTE);
        normals->allocateImage(width, height, 1, GL_RGBA, GL_FLOAT);
        normals->setInternalTextureFormat(GL_RGBA32F_ARB);
        look();
        viewer().setLightingMode(lighting);
        const osg::ref_ptr<osg::Camera> camera = new osg::Camera;
        camera->setRenderOrder(osg::Camera::PRE_RENDER);
        camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
        camera->setViewport(0, 0, width, height);
        camera->setClearColor(osg::Vec4(0, 0, 0, 0));
        camera->setClearMask(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        camera->attach(osg::Camera::COLOR_BUFFER0, albedo);
        camera->attach(osg::Camera::COLOR_BUFFER1, normals);
        camera->addChild(forest());
        const osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(camera);
        viewer().setSceneData(root);
        for (int i = 0; i < 10; ++i)
            frame(i / 25.0);
        return std::pair(albedo, normals);
    };
    const auto [albedo, normals] = drawn(osg::View::HEADLIGHT);
    const auto [dark, others] = drawn(osg::View::NO_LIGHT);
    EXPECT_GT(covered(*albedo), 0.03);
    EXPECT_EQ(difference(*albedo, *dark).mean, 0.0);
    int found = 0, towardEye = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const osg::Vec4 normal = normals->getColor(static_cast<unsigned>(x), static_cast<unsigned>(y));
            if (normal.a() == 0.0f)
                continue;
            ++found;
            towardEye += normal.z() > 0.0f;
            EXPECT_NEAR(osg::Vec3(normal.x(), normal.y(), normal.z()).length(), 1.0f, 1e-3f);
        }
    EXPECT_GT(found, 300);
    EXPECT_GT(towardEye, 0.55 * found);
}

TEST_P(SurfaceGlTest, AFileOfAnEarlierReleaseWorksInACompatibilityProfile) {
    if (!hasFixedFunction)
        GTEST_SKIP() << "OSG draws in core profiles only";
    const osg::ref_ptr<osg::Image> expected = picture(forest());
    const TemporaryFolder folder;
    folder.write("surface.glsl",
                 "#ifdef VERTEX_SHADER\n"
                 "void placeSurface(vec4 eye, vec3 normal, float tree) {\n"
                 "    gl_ClipVertex = eye;\n"
                 "    gl_Position = gl_ProjectionMatrix * eye;\n"
                 "}\n"
                 "#else\n"
                 "void paintSurface(vec3 color, vec3 albedo) { gl_FragColor = vec4(color.gbr, 1.0); }\n"
                 "#endif\n");
    const FilePath path(folder.path());
    const osg::ref_ptr<osg::Image> found = picture(forest());
    for (int i = 0; i < width * height; ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(found->data()[4 * i + c], expected->data()[4 * i + (c + 1) % 3], 1) << i;
}

TEST_P(SurfaceGlTest, EachTreeHasAnObjectId) {
    const FilePath path = replaced("object_ids");
    const osg::ref_ptr<osg::Image> ids = picture(forest());
    std::set<osg::Vec4ub> colours;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            colours.insert(pixel(x, y));
    EXPECT_EQ(colours.size(), 5u) << "four trees and the background";
}

INSTANTIATE_TEST_SUITE_P(Ways, SurfaceGlTest, ::testing::Values(Way::Modal, Way::Branchwise),
                         [](const auto& way) { return way.param == Way::Modal ? "modal" : "branchwise"; });
