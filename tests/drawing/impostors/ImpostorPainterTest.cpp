// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/impostors/ImpostorPainter.h>

#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/model/TreeSize.h>

#include <gtest/gtest.h>

#include <cstring>

using namespace osgTreeWind;

namespace {

const TreeModel& tree() {
    static const TreeModel model = makeTreeModel({});
    return model;
}

ImpostorPictures painted(float leaves = 1.0f) {
    ImpostorSettings settings;
    settings.leaves = leaves;
    return paintImpostor(tree(), {}, settings);
}

const unsigned char* level(const osg::Image& image, int index) {
    return index ? image.getMipmapData(static_cast<unsigned>(index)) : image.data();
}

/// Coverage of the first row of pictures at a mipmap level, in pictures.
double coverage(const ImpostorPictures& pictures, int index) {
    const int count = (pictures.colors->s() >> index) * (pictures.pixels >> index);
    double sum = 0.0;
    for (int i = 0; i < count; ++i)
        sum += level(*pictures.colors, index)[4 * i + 3] / 255.0;
    return sum / count * pictures.azimuths;
}

/// Area of a tree from the side, in units that are equal for all trees.
double area(const ImpostorPictures& pictures) {
    const glm::vec2 extent = pictures.extents.front();
    return coverage(pictures, 0) * pictures.halfWidth * (extent.y - extent.x);
}

} // namespace

TEST(ImpostorPainter, PicturesFormAGrid) {
    const ImpostorPictures pictures = painted();
    EXPECT_EQ(pictures.colors->s(), 8 * 64);
    EXPECT_EQ(pictures.colors->t(), 4 * 64);
    EXPECT_EQ(pictures.normals->s(), 8 * 64);
    EXPECT_EQ(pictures.levels(), 4);
    EXPECT_NEAR(pictures.height, measureTree(tree()).height, 0.1f);
    EXPECT_EQ(pictures.extents.size(), 4u);
}

TEST(ImpostorPainter, PicturesHaveEmptyMargins) {
    const ImpostorPictures pictures = painted();
    const int margin = 4; // a sixteenth
    for (int y = 0; y < pictures.colors->t(); ++y)
        for (int x = 0; x < pictures.colors->s(); ++x)
            if (x % 64 < margin || x % 64 >= 64 - margin || y % 64 < margin || y % 64 >= 64 - margin) {
                ASSERT_EQ(pictures.colors->data(x, y)[3], 0) << x << ", " << y;
            }
}

TEST(ImpostorPainter, NoColourIsBrighterThanItsCoverage) {
    const ImpostorPictures pictures = painted();
    for (int i = 0; i < pictures.colors->s() * pictures.colors->t(); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_LE(pictures.colors->data()[4 * i + c], pictures.colors->data()[4 * i + 3]);
}

TEST(ImpostorPainter, MipmapLevelsHaveEqualCoverage) {
    const ImpostorPictures pictures = painted();
    for (int index = 1; index < pictures.levels(); ++index)
        EXPECT_NEAR(coverage(pictures, index) / coverage(pictures, 0), 1.0, 0.03) << index;
}

TEST(ImpostorPainter, SmallPicturesHaveEqualCoverage) {
    for (const float leaves : {1.0f, 0.5f, 0.0f}) {
        ImpostorSettings small, large;
        small.leaves = large.leaves = leaves;
        small.pixels = 32;
        large.pixels = 512;
        EXPECT_NEAR(coverage(paintImpostor(tree(), {}, small), 0) /
                        coverage(paintImpostor(tree(), {}, large), 0),
                    1.0, 0.03)
            << leaves;
    }
}

TEST(ImpostorPainter, BareTreeShowsTwigsAndNoGreen) {
    TreeParameters leafless;
    leafless.leaves.clustersPerBranch = 0;
    const ImpostorPictures poles = paintImpostor(makeTreeModel(leafless), {});
    const ImpostorPictures bare = painted(0.0f), full = painted(), half = painted(0.5f);
    double red = 0.0, green = 0.0;
    for (int i = 0; i < bare.colors->s() * bare.colors->t(); ++i) {
        red += bare.colors->data()[4 * i];
        green += bare.colors->data()[4 * i + 1];
    }
    EXPECT_GT(red, green);
    EXPECT_GT(area(bare), 1.1 * area(poles));
    EXPECT_LT(coverage(bare, 0), 0.95 * coverage(half, 0));
    EXPECT_LT(coverage(half, 0), coverage(full, 0));
}

TEST(ImpostorPainter, MeanNormalFacesTheEye) { // first column: seen from +x
    const ImpostorPictures pictures = painted();
    double sum[2] = {0.0, 0.0}, covered = 0.0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            for (int axis = 0; axis < 2; ++axis)
                sum[axis] += pictures.normals->data(x, y)[axis];
            covered += pictures.colors->data(x, y)[3];
        }
    EXPECT_GT(2.0 * sum[0] / covered - 1.0, 0.2); // many normals point up
    EXPECT_NEAR(2.0 * sum[1] / covered - 1.0, 0.0, 0.1);
}

TEST(ImpostorPainter, ThreadsPaintTheSamePictures) {
    ImpostorPictures pictures[4];
    ThreadPool::executor()(4, [&](std::size_t i) { pictures[i] = painted(); });
    for (int i = 1; i < 4; ++i) {
        EXPECT_EQ(std::memcmp(pictures[0].colors->data(), pictures[i].colors->data(),
                              pictures[0].colors->getTotalSizeInBytesIncludingMipmaps()),
                  0);
        EXPECT_EQ(std::memcmp(pictures[0].normals->data(), pictures[i].normals->data(),
                              pictures[0].normals->getTotalSizeInBytesIncludingMipmaps()),
                  0);
    }
}
