// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>
#include <tests/MessageCollector.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/drawing/looks/PictureSize.h>
#include <osgTreeWind/drawing/looks/TreePicture.h>
#include <osgTreeWind/drawing/looks/TreeTextures.h>

#include <osgDB/WriteFile>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

/// The left half is transparent. The upper right quarter is twice as bright (linear) as the lower one.
std::string writePicture(const TemporaryFolder& folder) {
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(100, 60, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 100; ++x) {
            const unsigned char shade = y < 30 ? 124 : 169; // 0.2 and 0.4
            const unsigned char color[4] = {shade, shade, shade,
                                            static_cast<unsigned char>(x < 50 ? 0 : 255)};
            std::copy(color, color + 4, image->data(x, y));
        }
    const std::string path = folder.path() + "/spray.png";
    EXPECT_TRUE(osgDB::writeImageFile(*image, path));
    return path;
}

} // namespace

TEST(TreePicture, BecomesALeafCard) {
    const TemporaryFolder folder;
    const osg::ref_ptr<osg::Image> leaf = readLeafPicture(writePicture(folder));
    ASSERT_TRUE(leaf);
    EXPECT_EQ(leaf->s(), 512);
    EXPECT_EQ(leaf->getNumMipmapLevels(), 10u);
    const unsigned char *low = leaf->data(200, 50), *high = leaf->data(200, 200), *off = leaf->data(50, 50);
    EXPECT_NEAR(low[0], 0.8 * 2.0 / 3.0 * 255.0, 4.0);
    EXPECT_EQ(high[0], 255); // 4/3 of the mean, clamped
    EXPECT_NEAR(low[1], 128, 2) << "grey has no hue";
    EXPECT_EQ(low[2], 0) << "pictures have no twigs";
    EXPECT_EQ(low[3], 255);
    EXPECT_EQ(off[3], 0);
}

TEST(TreePicture, BecomesBarkWhoseBrightPartsStandOut) {
    const TemporaryFolder folder;
    const osg::ref_ptr<osg::Image> bark = readBarkPicture(writePicture(folder));
    ASSERT_TRUE(bark);
    EXPECT_GT(bark->data(200, 400)[0], bark->data(200, 100)[0]);
    EXPECT_GT(bark->data(200, 400)[1], bark->data(200, 100)[1]);
}

TEST(TreePicture, IsReadOnceAndShared) {
    const TemporaryFolder folder;
    Appearance appearance;
    appearance.leafImage = writePicture(folder);
    const osg::ref_ptr<osg::Image> one = leafImage(appearance), other = leafImage(appearance);
    EXPECT_EQ(one, other);
    EXPECT_NE(one, leafImage({}));
    const osg::ref_ptr<osg::Texture2D> texture = leafTexture(appearance);
    EXPECT_EQ(texture, leafTexture(appearance));
    EXPECT_NE(texture, leafTexture({}));
    std::vector<Species> species(2);
    species[1].appearance = appearance;
    const std::vector<osg::ref_ptr<osg::Texture2D>> all = treeTextures(species, runInTurn);
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[0], leafTexture({}));
    EXPECT_EQ(all[1], texture);
    EXPECT_EQ(all[2], barkTexture({}));
    EXPECT_EQ(all[3], all[2]);
}

TEST(TreePicture, UnreadableFileIsReportedAndReplaced) {
    const TemporaryFolder folder;
    const ScopedMessages messages;
    Appearance appearance;
    appearance.leafImage = folder.write("spray.png", "no picture");
    appearance.barkImage = folder.path() + "/no.png";
    const osg::ref_ptr<osg::Image> leaves = leafImage(appearance), bark = barkImage(appearance);
    EXPECT_EQ(leaves, leafImage({}));
    EXPECT_EQ(bark, barkImage({}));
    const std::string said = messages.take();
    EXPECT_NE(said.find("spray.png\" as a picture"), std::string::npos) << said;
    EXPECT_NE(said.find("no.png\" as a picture"), std::string::npos) << said;
}

TEST(TreePicture, IsNotReadBeyondTheMemoryLimit) {
    const TemporaryFolder folder;
    const std::string png = writePicture(folder), jpeg = folder.path() + "/bark.jpg";
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(640, 480, 1, GL_RGB, GL_UNSIGNED_BYTE);
    EXPECT_TRUE(osgDB::writeImageFile(*image, jpeg));
    const ScopedMessages messages;
    for (const char* size : {"3M", "20k"}) {
        const EnvironmentVariable limit("OSGTREEWIND_MAX_MEMORY", size);
        readBarkPicture(jpeg);
        readLeafPicture(png);
    }
    const std::string said = messages.take();
    EXPECT_EQ(said.find("its pixels need about 48 kB of memory; the limit is 20 kB"),
              said.rfind("its pixels need about 48 kB"))
        << said;
    EXPECT_NE(said.find("bark.jpg\": its pixels need about 2.46 MB of memory; the limit is 20 kB"),
              std::string::npos)
        << said;
    EXPECT_EQ(said.find("limit is 3 MB"), std::string::npos) << said;
}

TEST(PictureSize, IsEmptyForUnknownAndTruncatedFiles) {
    for (const std::string& bytes : {std::string(), std::string("\x89PNG"), std::string("\xff\xd8\xff"),
                                     std::string("\xff\xd8\xff\xe0\0\0\xff\xc0", 8), std::string("GIF89a")}) {
        std::istringstream file(bytes);
        EXPECT_FALSE(pictureSize(file)) << bytes;
    }
}
