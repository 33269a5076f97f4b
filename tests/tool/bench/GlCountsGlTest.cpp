// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>

#include <examples/osgtreewind/bench/GlCounts.h>
#include <examples/osgtreewind/bench/TextureFetches.h>

#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/nodes/Forest.h>

#include <osg/Geometry>
#include <osg/Texture2D>

namespace {

using namespace osgTreeWind;

/// Counts a frame of small scenes after others that compile and upload.
class GlCountsGlTest : public GlTest {
protected:
    GlCounts countFrame(
        osg::Node* scene, const std::function<void()>& change = [] {}) {
        open(64, 64);
        viewer().getCamera()->setViewMatrix(osg::Matrix());
        viewer().getCamera()->setProjectionMatrixAsOrtho(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
        viewer().setSceneData(scene);
        for (int i = 0; i < 3; ++i)
            frame(0.1 * i);
        change();
        return countGlCalls([this] { frame(0.3); }, true);
    }

    /// The lower left half of the view.
    static osg::ref_ptr<osg::Geometry> triangle() {
        osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
        osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
        for (const osg::Vec2 corner :
             {osg::Vec2(-1.0f, -1.0f), osg::Vec2(1.0f, -1.0f), osg::Vec2(-1.0f, 1.0f)})
            corners->push_back({corner, 0.0f});
        geometry->setVertexArray(corners);
        geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, 3));
        geometry->setUseDisplayList(false);
        geometry->setUseVertexBufferObjects(true);
        geometry->setDataVariance(osg::Object::DYNAMIC);
        geometry->getOrCreateStateSet()->setAttribute(makeProgram(
            "test", "void main() { gl_Position = osg_Vertex; }",
            "uniform sampler2D picture;\nout vec4 color;\n"
            "void main() { color = texture(picture, vec2(0.5)) + texelFetch(picture, ivec2(0), 0); }"));
        return geometry;
    }
};

TEST_F(GlCountsGlTest, ATriangleIsOneDraw) {
    const GlCounts counts = countFrame(triangle());
    EXPECT_EQ(counts.of(GlCall::Draw), 1u);
    EXPECT_EQ(counts.of(GlCall::InstancedDraw) + counts.of(GlCall::MultiDraw), 0u);
    EXPECT_EQ(counts.bufferBytes + counts.textureBytes, 0u);

    const DrawWork& work = counts.work[static_cast<std::size_t>(DrawnPart::Other)];
    EXPECT_EQ(work.draws, 1u);
    EXPECT_EQ(work.counts[DrawWork::Vertices], 3u);
    EXPECT_EQ(work.counts[DrawWork::ShadedVertices], 3u);
    EXPECT_EQ(work.counts[DrawWork::Primitives], 1u);
    EXPECT_EQ(work.counts[DrawWork::ClippedPrimitives], 1u);
    EXPECT_NEAR(double(work.counts[DrawWork::Fragments]), 0.5 * 64 * 64, 64.0);
    EXPECT_GE(work.counts[DrawWork::ShadedFragments], work.counts[DrawWork::Fragments]);
    EXPECT_EQ(work.counts[DrawWork::LeastTextureFetches], 2 * work.counts[DrawWork::Fragments]);
}

TEST_F(GlCountsGlTest, CountsUploadedBytes) {
    const osg::ref_ptr<osg::Geometry> geometry = triangle();
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(8, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    geometry->getStateSet()->setTextureAttribute(0, new osg::Texture2D(image));
    const GlCounts counts = countFrame(geometry, [&] {
        geometry->getVertexArray()->dirty();
        image->dirty();
    });
    EXPECT_EQ(counts.bufferBytes, 3 * sizeof(osg::Vec3));
    EXPECT_EQ(counts.textureBytes, 8u * 4u * 4u);
}

TEST_F(GlCountsGlTest, TreesOfOneShapeShareDrawsOfLeavesAndBark) {
    const auto countTrees = [this](int trees) {
        ForestDescription description;
        description.species = {*findSpecies("oak")};
        description.species.front().shapes = 1;
        description.drawing.tiers = false;
        for (int i = 0; i < trees; ++i) {
            description.trees.emplace_back();
            description.trees.back().position = {0.1 * i, 0.0, 0.0};
        }
        return countFrame(new Forest(description));
    };
    const auto drawsOf = [](const GlCounts& counts, DrawnPart part) {
        return counts.work[static_cast<std::size_t>(part)].draws;
    };
    const GlCounts one = countTrees(1), three = countTrees(3);
    for (const DrawnPart part : {DrawnPart::Leaves, DrawnPart::Bark, DrawnPart::Poses}) {
        EXPECT_GT(drawsOf(one, part), 0u);
        EXPECT_EQ(drawsOf(one, part), drawsOf(three, part));
    }
}

TEST(TextureFetchesTest, CountsCallsOfFunctionsOnceForEachCaller) {
    EXPECT_EQ(
        textureFetches("vec4 twice(vec2 at) { return texture(a, at) + textureLod(a, at, 0.0); } // texture(\n"
                       "void unused() { texelFetch(a, at, 0); }\n"
                       "void main() { twice(p); vec2 size = textureSize(a, 0); twice(q); }"),
        4);
}

TEST(TextureFetchesTest, LeavesOutWhatIsNotDefined) {
    EXPECT_EQ(textureFetches("#define PLACE(x) vec2(x, \\\n x)\nvoid main() { texture(a, PLACE(0)); }"), 1);
    const std::string text = "#ifdef ONE\nvoid main() { texture(a, p); }\n#else\nvoid main() {}\n#endif\n";
    EXPECT_EQ(textureFetches(text), 0);
    EXPECT_EQ(textureFetches("#define ONE\n" + text), 1);
}

TEST(TextureFetchesTest, MultipliesByConstantBoundsOfLoops) {
    EXPECT_EQ(textureFetches("const int most = 3;\nvoid main() {\n"
                             "for (int i = 0; i < most; ++i) { for (int j = 0; j < 2; ++j) texture(a, p); }\n"
                             "for (int i = 0; i < length; ++i) texture(a, p);\ntexture(a, p); }"),
              8);
}

} // namespace
