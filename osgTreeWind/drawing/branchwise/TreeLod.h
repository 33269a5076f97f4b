// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/TreeLodRanges.h>

#include <osg/LOD>

#include <atomic>

namespace osgTreeWind {

/// The levels of detail of one tree, by distance (thesis §7). Below the TreeNode,
/// which fills them. A level that no camera sees costs nothing: the transforms of FULL are turned for those
/// who look at them only. Where they are not yet, its stand-in is drawn, which shaders pose: the same
/// picture, but that its leaves are shaded as a crown.
class TreeLod : public osg::LOD {
public:
    enum Level {
        FULL,      ///< As the forest's drawing has it: a transform a branch and a leaf cluster.
        LEAVES,    ///< All leaves in one draw, and the bark that bears none in another; no transforms.
        BILLBOARD, ///< A picture of the tree; empty while there is none.
        STAND_IN   ///< Bark and leaves in one draw each; never by distance.
    };

    TreeLod();
    /// @param height of the tree, metres.
    explicit TreeLod(float height);
    /// A level of its own for each of those of `other`, with the same children.
    TreeLod(const TreeLod& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, TreeLod)

        osg::Group* level(Level level) const {
        return static_cast<osg::Group*>(const_cast<osg::Node*>(getChild(level)));
    }

    void setRanges(const TreeLodRanges& ranges);
    const TreeLodRanges& getRanges() const { return _ranges; }

    /// Whether a camera asked for FULL since the last call. During update.
    bool takeWanted() { return _wanted.exchange(false); }
    /// Whether FULL may be drawn. During update.
    void setReady(bool ready) { _ready = ready; }
    bool getReady() const { return _ready; }

    void traverse(osg::NodeVisitor& visitor) override;

protected:
    ~TreeLod() override = default;

private:
    TreeLodRanges _ranges;
    float _height = 1.0f;
    std::atomic<bool> _wanted{false};
    bool _ready = true;
};

} // namespace osgTreeWind
