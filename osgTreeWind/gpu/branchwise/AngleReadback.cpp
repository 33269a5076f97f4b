// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/branchwise/AngleReadback.h>

namespace osgTreeWind {

void AngleReadback::read(const osg::State& state, int width, int height) {
    const std::lock_guard<std::mutex> lock(_mutex);
    const unsigned frame = state.getFrameStamp() ? state.getFrameStamp()->getFrameNumber() : 0;
    if (_fresh && frame <= _frame)
        return; // another context was first
    _states.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, _states.data());
    _frame = frame;
    _fresh = true;
}

bool AngleReadback::take(std::vector<glm::vec4>& states) {
    const std::lock_guard<std::mutex> lock(_mutex);
    if (!_fresh)
        return false;
    states.swap(_states);
    _fresh = false;
    return true;
}

} // namespace osgTreeWind
