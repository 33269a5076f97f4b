// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/SceneGeometry.h>

#include <functional>
#include <mutex>

namespace osgTreeWind {

/// A geometry that keeps no vertices and indices after OpenGL has them. An InstancedDraw draws it.
class RefilledGeometry : public SceneGeometry {
public:
    using Maker = std::function<osg::ref_ptr<osg::Geometry>()>;

    /// @param full its first primitives are DrawElements, its arrays vertex attributes. They are taken over.
    /// @param again makes the same for other contexts and after releaseGLObjects(), in any thread.
    RefilledGeometry(osg::Geometry& full, Maker again);

    /// Gives OpenGL the vertices and indices that it does not have in a context. In a draw.
    void fillBuffers(osg::State& state) const;
    void compileGLObjects(osg::RenderInfo& renderInfo) const override;

protected:
    ~RefilledGeometry() override = default;

private:
    bool isMissing(unsigned context) const;
    void refill() const;
    void empty() const;

    const Maker _again;
    ArrayList _arrays;
    osg::ref_ptr<osg::DrawElements> _elements;
    mutable std::mutex _mutex; ///< Guards what `_arrays` and `_elements` contain.
};

} // namespace osgTreeWind
