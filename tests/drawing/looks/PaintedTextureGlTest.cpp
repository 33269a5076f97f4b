// SPDX-License-Identifier: MIT
#include <tests/drawing/looks/SameImage.h>
#include <tests/gl/GlTest.h>

#include <osgTreeWind/drawing/looks/PaintedTexture.h>

#include <stdexcept>

using namespace osgTreeWind;

namespace {

osg::ref_ptr<osg::Image> chequers() {
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(16, 8, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    for (unsigned i = 0; i < image->getTotalSizeInBytes(); ++i)
        image->data()[i] = static_cast<unsigned char>(i / 4 % 3 * 40 + i % 4 * 30);
    return image;
}

class PaintedTextureGlTest : public GlTest {
protected:
    PaintedTextureGlTest() { openContext(); }

    void openContext() {
        open(8, 8);
        frame(0.0);
    }
    /// Applies a texture and reads what OpenGL has.
    osg::ref_ptr<osg::Image> applied(const osg::Texture2D& texture) {
        context().makeCurrent();
        texture.apply(*context().getState());
        osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(16, 8, 1, GL_RGBA, GL_UNSIGNED_BYTE);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, image->data());
        context().releaseContext();
        return image;
    }
};

} // namespace

TEST_F(PaintedTextureGlTest, KeepsItsImageUntilOpenGLHasIt) {
    const osg::ref_ptr<osg::Image> image = chequers();
    int painted = 0;
    const osg::ref_ptr<osg::Texture2D> texture = makePaintedTexture(
        "chequers", image,
        [&] {
            ++painted;
            return chequers();
        },
        osg::Texture::REPEAT);
    EXPECT_EQ(image->referenceCount(), 2);
    EXPECT_TRUE(isSameImage(*applied(*texture), *image));
    EXPECT_EQ(image->referenceCount(), 1);
    EXPECT_TRUE(isSameImage(*applied(*texture), *image));
    EXPECT_EQ(painted, 0);
    texture->releaseGLObjects();
    EXPECT_TRUE(isSameImage(*applied(*texture), *image));
    EXPECT_EQ(painted, 1);
    openContext();
    EXPECT_TRUE(isSameImage(*applied(*texture), *image)) << "in a second context";
    EXPECT_EQ(painted, 2);
}

TEST_F(PaintedTextureGlTest, KeepsACompressedCopyInstead) {
    const osg::ref_ptr<osg::Image> image = chequers();
    const osg::ref_ptr<osg::Texture2D> texture =
        makePaintedTexture("chequers", image, nullptr, osg::Texture::REPEAT);
    EXPECT_EQ(image->referenceCount(), 1);
    for (int i = 0; i < 3; ++i) {
        EXPECT_TRUE(isSameImage(*applied(*texture), *image));
        texture->releaseGLObjects();
    }
}

TEST_F(PaintedTextureGlTest, WarnsIfItCannotBePaintedAgain) {
    const osg::ref_ptr<osg::Texture2D> texture = makePaintedTexture(
        "chequers", chequers(), []() -> osg::ref_ptr<osg::Image> { throw std::runtime_error("no colour"); },
        osg::Texture::REPEAT);
    applied(*texture);
    EXPECT_EQ(takeMessages(), "");
    texture->releaseGLObjects();
    applied(*texture);
    EXPECT_NE(takeMessages().find("no colour; a texture of trees is missing"), std::string::npos);
}
