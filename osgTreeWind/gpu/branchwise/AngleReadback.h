// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Camera>
#include <osg/Texture2D>

#include <glm/vec4.hpp>

#include <mutex>
#include <vector>

namespace osgTreeWind {

/// Brings the states of a pass back to the CPU: as PostDrawCallback of the pass's cameras it copies the
/// texture the camera drew into, in the draw thread; take() hands the newest copy over in update. Two buffers
/// and a lock keep a copy whole; each is stamped with the frame that drew it, so that update of frame N gets
/// frame N - 1.
class AngleReadback : public osg::Camera::DrawCallback {
public:
    void operator()(osg::RenderInfo& renderInfo) const override;

    /// The newest states, unless they were taken before.
    /// @param states becomes all texels of the texture, padding included.
    /// @return whether there were any.
    bool take(std::vector<glm::vec4>& states);

private:
    mutable std::mutex _drawing; // one context at a time; guards _back
    mutable std::vector<glm::vec4> _back;
    mutable std::mutex _mutex; // guards all below
    mutable std::vector<glm::vec4> _front;
    mutable unsigned _frame = 0;
    mutable bool _fresh = false;
};

} // namespace osgTreeWind
