// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Image>

#include <glm/vec4.hpp>

namespace osgTreeWind {

/// Square pictures in rows and columns, in two RGBA images with all their mipmaps: colours and normals, both
/// times the coverage, which is the alpha of the colours.
class ImpostorAtlas {
public:
    ImpostorAtlas(int columns, int rows, int pixels);

    void set(int column, int row, int x, int y, const glm::vec4& color, const glm::vec4& normal);
    /// Makes a mipmap from the one before it.
    void shrink(int level);

    osg::Image* colors() const { return _colors.get(); }
    osg::Image* normals() const { return _normals.get(); }

private:
    int _pixels;
    osg::ref_ptr<osg::Image> _colors, _normals;
};

} // namespace osgTreeWind
