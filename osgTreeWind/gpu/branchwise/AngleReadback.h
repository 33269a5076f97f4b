// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Referenced>
#include <osg/State>

#include <glm/vec4.hpp>

#include <mutex>
#include <vector>

namespace osgTreeWind {

/// Brings the states of a pass back to the CPU: the draw thread copies them when the pass is drawn; take()
/// hands the copy over in update. It is stamped with the frame that drew it, so that update of frame N gets
/// frame N - 1.
class AngleReadback : public osg::Referenced {
public:
    /// Copies the texture of that many texels that is bound to the active texture unit. In the draw thread.
    void read(const osg::State& state, int width, int height);

    /// The newest states, unless they were taken before.
    /// @param states becomes all texels of the texture, padding included.
    /// @return whether there were any.
    bool take(std::vector<glm::vec4>& states);

private:
    std::mutex _mutex; // guards all below
    std::vector<glm::vec4> _states;
    unsigned _frame = 0;
    bool _fresh = false;
};

} // namespace osgTreeWind
