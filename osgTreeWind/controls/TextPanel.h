// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Camera>
#include <osgText/Text>

#include <string>

namespace osgTreeWind {

/// Two texts over the scene, scaled to the window: at the lower left, below OSG's statistics, and in the
/// middle.
class TextPanel {
public:
    TextPanel();

    /// The camera that draws the texts after the scene.
    osg::Camera* camera() { return _camera.get(); }
    /// Sets the size of the window in pixels.
    void setSize(int width, int height);
    /// Sets the texts: UTF-8, aligned for a monospace font; empty: hidden. Between frames.
    void show(const std::string& corner, const std::string& middle);

private:
    osg::Vec2 _size; ///< Pixels.
    osg::ref_ptr<osg::Camera> _camera;
    osg::ref_ptr<osgText::Text> _corner, _middle;
};

} // namespace osgTreeWind
