// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/PosePass.h>
#include <osgTreeWind/nodes/SceneShading.h>

#include <osgUtil/RenderStage>

#include <utility>
#include <vector>

namespace osgTreeWind {

/// What is done before a camera that sees trees draws anything: their poses are worked out, which others that draw
/// the same trees in the same frame and context find done, and what the scene says of light is put into their state.
class PoseStage : public osgUtil::RenderStage {
public:
    /// @param place of the trees in the scene's state.
    void begin(osgUtil::StateGraph* place) {
        _place = place;
        _work.clear();
    }
    void reset() override {}
    void add(const PosePass* passes, const PosePage* page) { _work.emplace_back(passes, page); }

    /// State of the trees that this camera sees, to be filled in before they are drawn.
    osg::StateSet* shading() const { return _shading.get(); }

    void draw(osg::RenderInfo& renderInfo, osgUtil::RenderLeaf*&) override {
        setSceneDefines(*_shading, _place);
        for (const auto& work : _work)
            work.first->prepare(*renderInfo.getState(), *work.second);
    }

private:
    osg::ref_ptr<osgUtil::StateGraph> _place;
    osg::ref_ptr<osg::StateSet> _shading = new osg::StateSet;
    std::vector<std::pair<osg::ref_ptr<const PosePass>, osg::ref_ptr<const PosePage>>> _work;
};

} // namespace osgTreeWind
