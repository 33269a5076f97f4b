// SPDX-License-Identifier: MIT
#pragma once

#include <osg/NodeVisitor>

/// Traverses a scene like the cull of a camera that is `distance` metres away from every node.
class FakeCullVisitor : public osg::NodeVisitor {
public:
    explicit FakeCullVisitor(float distance)
        : osg::NodeVisitor(CULL_VISITOR, TRAVERSE_ACTIVE_CHILDREN), _distance(distance) {}
    float getDistanceToViewPoint(const osg::Vec3&, bool) const override { return _distance; }
    void apply(osg::Drawable& drawable) override { drawn.push_back(&drawable); }

    std::vector<osg::Drawable*> drawn;

private:
    float _distance;
};
