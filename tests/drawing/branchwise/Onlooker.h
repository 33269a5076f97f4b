// SPDX-License-Identifier: MIT
#pragma once

#include <osg/NodeVisitor>

/// Traverses a scene as the cull of a camera does that stands `distance` metres from everything.
class Onlooker : public osg::NodeVisitor {
public:
    explicit Onlooker(float distance)
        : osg::NodeVisitor(CULL_VISITOR, TRAVERSE_ACTIVE_CHILDREN), _distance(distance) {}
    float getDistanceToViewPoint(const osg::Vec3&, bool) const override { return _distance; }
    void apply(osg::Drawable& drawable) override { drawn.push_back(&drawable); }

    std::vector<osg::Drawable*> drawn;

private:
    float _distance;
};
