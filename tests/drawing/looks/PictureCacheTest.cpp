// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>
#include <tests/drawing/looks/SameImage.h>
#include <tests/io/FileBytes.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/drawing/looks/PictureCache.h>
#include <osgTreeWind/drawing/looks/TreeTextures.h>

#include <osgDB/WriteFile>

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>

using namespace osgTreeWind;

namespace {

namespace files = std::filesystem;

/// An image with mipmaps, of runs of equal texels and others.
osg::ref_ptr<osg::Image> imageOf(unsigned char value) {
    osg::ref_ptr<osg::Image> image = new osg::Image;
    const unsigned bytes = 4 * (8 * 4 + 4 * 2 + 2 * 1 + 1);
    auto* texels = new unsigned char[bytes];
    std::memset(texels, value, bytes);
    for (unsigned i = 20; i < 100; ++i)
        texels[i] = static_cast<unsigned char>(i / 3 % 16 * value);
    image->setImage(8, 4, 1, GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE, texels, osg::Image::USE_NEW_DELETE);
    image->setMipmapLevels({128, 160, 168});
    return image;
}

/// Calls cachedImage() and counts how often it paints.
struct Painter {
    int painted = 0;

    osg::ref_ptr<osg::Image> image(const std::string& work, unsigned char value = 7) {
        return cachedImage(work, [&] {
            ++painted;
            return imageOf(value);
        });
    }
};

void writePicture(const std::string& path, unsigned char shade) {
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(20, 10, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    std::memset(image->data(), 200, image->getTotalSizeInBytes());
    *image->data(5, 5) = shade;
    ASSERT_TRUE(osgDB::writeImageFile(*image, path));
}

} // namespace

TEST(PictureCache, PaintsOnceAndThenReads) {
    const TemporaryFolder folder;
    const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", folder.path().c_str());
    Painter painter;
    EXPECT_TRUE(isSameImage(*painter.image("a"), *imageOf(7)));
    EXPECT_TRUE(isSameImage(*painter.image("a", 8), *imageOf(7)));
    EXPECT_EQ(painter.painted, 1);
    EXPECT_TRUE(isSameImage(*painter.image("b", 8), *imageOf(8)));
    EXPECT_EQ(painter.painted, 2);
}

TEST(PictureCache, PaintsDamagedFilesAnew) {
    const TemporaryFolder folder;
    const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", folder.path().c_str());
    Painter painter;
    painter.image("a");
    const std::string file = files::directory_iterator(folder.path())->path().string(), whole = bytesOf(file);
    for (std::size_t size = 0; size < whole.size(); size += 5) {
        std::ofstream(file, std::ios::binary) << whole.substr(0, size);
        const int before = painter.painted;
        EXPECT_TRUE(isSameImage(*painter.image("a"), *imageOf(7)));
        EXPECT_EQ(painter.painted, before + 1) << "cut at " << size;
        EXPECT_EQ(bytesOf(file), whole);
    }
}

TEST(PictureCache, PaintsWithoutAFolder) {
    for (const char* place : {"off", "/proc/no/such", "/dev/full"}) {
        const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", place);
        Painter painter;
        EXPECT_TRUE(isSameImage(*painter.image(place), *imageOf(7)));
        EXPECT_TRUE(isSameImage(*painter.image(place), *imageOf(7)));
        EXPECT_EQ(painter.painted, 2);
    }
}

TEST(PictureCache, StoresNoFailure) {
    const TemporaryFolder folder;
    const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", folder.path().c_str());
    EXPECT_FALSE(cachedImage("a", [] { return osg::ref_ptr<osg::Image>(); }));
    EXPECT_EQ(folder.countFiles(), 0u);
}

TEST(PictureCache, RefusesBytesThatAreNoImage) {
    std::string bytes;
    appendImage(*imageOf(7), bytes);
    std::size_t place = 0;
    EXPECT_TRUE(takeImage(bytes, place));
    EXPECT_EQ(place, bytes.size());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        place = 0;
        EXPECT_FALSE(takeImage(bytes.substr(0, size), place)) << size;
    }
    for (const std::size_t field : {0, 4, 8, 12, 20}) {
        std::string damaged = bytes;
        damaged.replace(field, 4, "\xff\xff\xff\x7f");
        place = 0;
        EXPECT_FALSE(takeImage(damaged, place)) << field;
        damaged.replace(field, 4, "\xff\xff\xff\xff");
        place = 0;
        EXPECT_FALSE(takeImage(damaged, place)) << field;
    }
}

TEST(PictureCache, KeepsPicturesOfUsersByTheirBytes) {
    const TemporaryFolder folder, pictures;
    const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", folder.path().c_str());
    Appearance appearance;
    appearance.barkImage = pictures.path() + "/bark.png";
    writePicture(appearance.barkImage, 10);
    const osg::ref_ptr<osg::Image> first(osg::clone(barkImage(appearance).get(), osg::CopyOp::DEEP_COPY_ALL));
    EXPECT_EQ(folder.countFiles(), 1u);
    const std::string copy = pictures.path() + "/copy.png";
    files::copy_file(appearance.barkImage, copy);
    Appearance same;
    same.barkImage = copy;
    EXPECT_TRUE(isSameImage(*first, *barkImage(same)));
    EXPECT_EQ(folder.countFiles(), 1u) << "the same bytes";
    writePicture(appearance.barkImage, 90);
    EXPECT_FALSE(isSameImage(*first, *barkImage(appearance)));
    EXPECT_EQ(folder.countFiles(), 2u);
    appearance.leafImage = copy;
    EXPECT_TRUE(leafImage(appearance));
    EXPECT_EQ(folder.countFiles(), 3u) << "as leaves";
}
