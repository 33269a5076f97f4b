// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/branchwise/AngleReadback.h>

#include <osg/RenderInfo>
#include <osg/State>

namespace osgTreeWind {

void AngleReadback::operator()(osg::RenderInfo& renderInfo) const {
    const std::lock_guard<std::mutex> drawing(_drawing);
    osg::State& state = *renderInfo.getState();
    const auto& attachments = renderInfo.getCurrentCamera()->getBufferAttachmentMap();
    osg::Texture* texture = attachments.at(osg::Camera::COLOR_BUFFER0)._texture.get();
    const unsigned frame = state.getFrameStamp() ? state.getFrameStamp()->getFrameNumber() : 0;
    {
        const std::lock_guard<std::mutex> lock(_mutex);
        if (_fresh && frame <= _frame)
            return; // another context was first
    }
    const auto texels = static_cast<std::size_t>(texture->getTextureWidth()) *
                        static_cast<std::size_t>(texture->getTextureHeight());
    _back.resize(texels);
    state.setActiveTextureUnit(0);
    state.applyTextureAttribute(0, texture);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, _back.data());

    const std::lock_guard<std::mutex> lock(_mutex);
    _back.swap(_front);
    _frame = frame;
    _fresh = true;
}

bool AngleReadback::take(std::vector<glm::vec4>& states) {
    const std::lock_guard<std::mutex> lock(_mutex);
    if (!_fresh)
        return false;
    states.swap(_front);
    _fresh = false;
    return true;
}

} // namespace osgTreeWind
