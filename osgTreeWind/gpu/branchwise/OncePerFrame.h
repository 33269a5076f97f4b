// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Group>

#include <map>
#include <mutex>

namespace osgTreeWind {

/// Lets the first cull traversal of a frame in each context through, and no other: however many views, shadow
/// passes and cameras see a scene, what is below is drawn once.
class OncePerFrame : public osg::Group {
public:
    OncePerFrame() = default;
    OncePerFrame(const OncePerFrame& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY)
        : osg::Group(other, copyop) {}
    META_Node(osgTreeWind, OncePerFrame)

        void traverse(osg::NodeVisitor& visitor) override;

protected:
    ~OncePerFrame() override = default;

private:
    bool firstOfFrame(osg::NodeVisitor& visitor);

    std::mutex _mutex;
    std::map<unsigned, unsigned> _lastFrame; ///< By context.
};

} // namespace osgTreeWind
