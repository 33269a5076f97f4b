// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/PosePass.h>

#include <osgUtil/RenderStage>

#include <utility>
#include <vector>

namespace osgTreeWind {

/// Works out poses before the camera that needs them draws anything. Others that draw the same trees in the same frame
/// and context find them done.
class PoseStage : public osgUtil::RenderStage {
public:
    void reset() override { _work.clear(); }
    void add(const PosePass* passes, const PosePage* page) { _work.emplace_back(passes, page); }

    void draw(osg::RenderInfo& renderInfo, osgUtil::RenderLeaf*&) override {
        for (const auto& work : _work)
            work.first->prepare(*renderInfo.getState(), *work.second);
    }

private:
    std::vector<std::pair<osg::ref_ptr<const PosePass>, osg::ref_ptr<const PosePage>>> _work;
};

} // namespace osgTreeWind
