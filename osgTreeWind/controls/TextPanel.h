// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Camera>
#include <osgText/Text>

#include <string>

namespace osgTreeWind {

/// Two texts over a picture, of a size that can be read on any screen: one at the lower left (OSG's
/// statistics are above), and one that fills the middle.
class TextPanel {
public:
    TextPanel();

    /// Draws them, after all else.
    osg::Camera* camera() { return _camera.get(); }
    /// Of the window, pixels.
    void setSize(int width, int height);
    /// UTF-8, lines of columns; empty: none. Between frames.
    void show(const std::string& corner, const std::string& middle);

private:
    osg::Vec2 _size; ///< Pixels.
    osg::ref_ptr<osg::Camera> _camera;
    osg::ref_ptr<osgText::Text> _corner, _middle;
};

} // namespace osgTreeWind
