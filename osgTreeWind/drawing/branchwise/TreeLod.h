// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/TreeLodRanges.h>

#include <osg/LOD>

#include <atomic>

namespace osgTreeWind {

/// The levels of detail of one tree, by distance (thesis §7). The TreeNode above it fills them. The
/// transforms of FULL are updated only while a camera sees them. Until they are up to date, STAND_IN is drawn
/// instead, which shaders pose; it looks the same except for the crown shading of its leaves.
class TreeLod : public osg::LOD {
public:
    enum Level {
        FULL,      ///< A transform for each branch and each leaf cluster.
        LEAVES,    ///< One draw for all leaves and one for the bark without leaves; no transforms.
        BILLBOARD, ///< A picture of the tree. May be empty.
        STAND_IN   ///< One draw for the bark and one for the leaves. Replaces FULL; has no distance range.
    };

    TreeLod();
    /// @param height of the tree, metres.
    explicit TreeLod(float height);
    /// Copies the group of each level; the copies have the same children.
    TreeLod(const TreeLod& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, TreeLod)

    osg::Group* level(Level level) const {
        return static_cast<osg::Group*>(const_cast<osg::Node*>(getChild(level)));
    }

    void setRanges(const TreeLodRanges& ranges);
    const TreeLodRanges& getRanges() const { return _ranges; }

    /// Whether a camera requested FULL since the last call. In update.
    bool takeFullRequest() { return _fullRequested.exchange(false); }
    /// Sets whether the transforms of FULL are up to date. In update.
    void setFullReady(bool ready) { _fullReady = ready; }
    bool isFullReady() const { return _fullReady; }

    void traverse(osg::NodeVisitor& visitor) override;

protected:
    ~TreeLod() override = default;

private:
    TreeLodRanges _ranges;
    float _height = 1.0f;
    std::atomic<bool> _fullRequested{false};
    bool _fullReady = true;
};

} // namespace osgTreeWind
