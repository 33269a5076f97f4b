// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Drawable>

#include <atomic>

namespace osgTreeWind {

/// Finds out, when it is first drawn, whether a context can run the angle passes: draw into RGBA32F textures
/// and read textures in vertex shaders. Draws nothing.
class FloatTargetProbe : public osg::Drawable {
public:
    enum Answer { NOT_KNOWN_YET, SUPPORTED, MISSING };

    FloatTargetProbe();
    FloatTargetProbe(const FloatTargetProbe& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    using osg::Drawable::accept;
    META_Node(osgTreeWind, FloatTargetProbe)

        /// Any thread.
        Answer answer() const {
        return _answer;
    }

    osg::BoundingBox computeBoundingBox() const override { return {}; }
    void drawImplementation(osg::RenderInfo& renderInfo) const override;

protected:
    ~FloatTargetProbe() override = default;

private:
    mutable std::atomic<Answer> _answer{NOT_KNOWN_YET};
};

} // namespace osgTreeWind
