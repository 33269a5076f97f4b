// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/impostors/ImpostorAtlas.h>

#include <osgTreeWind/drawing/looks/ByteOf.h>

#include <algorithm>

namespace osgTreeWind {
namespace {

osg::ref_ptr<osg::Image> blankImage(int width, int height) {
    osg::Image::MipmapDataType offsets;
    unsigned bytes = 0;
    for (int w = width, h = height;; w = std::max(w / 2, 1), h = std::max(h / 2, 1)) {
        bytes += static_cast<unsigned>(4 * w * h);
        if (w == 1 && h == 1)
            break;
        offsets.push_back(bytes);
    }
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->setImage(width, height, 1, GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE, new unsigned char[bytes](),
                    osg::Image::USE_NEW_DELETE);
    image->setMipmapLevels(offsets);
    return image;
}

unsigned char* texels(osg::Image& image, int level) {
    return level ? image.getMipmapData(static_cast<unsigned>(level)) : image.data();
}

void halve(osg::Image& image, int level) {
    const unsigned char* from = texels(image, level - 1);
    unsigned char* to = texels(image, level);
    const int width = image.s() >> level, height = image.t() >> level, row = 8 * width;
    for (int y = 0; y < height; ++y)
        for (int i = 0; i < 4 * width; ++i) {
            const unsigned char* at = from + 2 * row * y + 8 * (i / 4) + i % 4;
            const int half = 1 + ((i / 4 + y) & 1); // rounded up as often as down: dark leaves are few steps
            *to++ = static_cast<unsigned char>((at[0] + at[4] + at[row] + at[row + 4] + half) / 4);
        }
}

} // namespace

ImpostorAtlas::ImpostorAtlas(int columns, int rows, int pixels)
    : _pixels(pixels), _colors(blankImage(columns * pixels, rows * pixels)),
      _normals(blankImage(columns * pixels, rows * pixels)) {}

void ImpostorAtlas::set(int column, int row, int x, int y, const glm::vec4& color, const glm::vec4& normal) {
    unsigned char* a = _colors->data(column * _pixels + x, row * _pixels + y);
    unsigned char* b = _normals->data(column * _pixels + x, row * _pixels + y);
    for (int c = 0; c < 4; ++c) {
        a[c] = byteOf(color[c]);
        b[c] = byteOf(normal[c]);
    }
}

void ImpostorAtlas::shrink(int level) {
    halve(*_colors, level);
    halve(*_normals, level);
}

} // namespace osgTreeWind
