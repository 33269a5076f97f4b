// SPDX-License-Identifier: MIT
#pragma once

#include <osg/FrameStamp>
#include <osgUtil/CullVisitor>
#include <osgUtil/RenderStage>

/// Runs the cull traversal of one frame for a camera at `eye` that looks at the origin.
inline void cull(osg::Node& scene, unsigned frame, const osg::Vec3d& eye) {
    osg::ref_ptr<osg::FrameStamp> stamp = new osg::FrameStamp;
    stamp->setFrameNumber(frame);
    osg::ref_ptr<osgUtil::CullVisitor> visitor = new osgUtil::CullVisitor;
    visitor->setFrameStamp(stamp);
    visitor->setTraversalNumber(frame);
    osg::ref_ptr<osgUtil::StateGraph> graph = new osgUtil::StateGraph;
    osg::ref_ptr<osgUtil::RenderStage> stage = new osgUtil::RenderStage;
    stage->setViewport(new osg::Viewport(0, 0, 64, 64));
    visitor->setStateGraph(graph);
    visitor->setRenderStage(stage);
    visitor->pushViewport(stage->getViewport());
    visitor->pushProjectionMatrix(new osg::RefMatrix(osg::Matrix::perspective(60, 1, 1, 1e5)));
    visitor->pushModelViewMatrix(
        new osg::RefMatrix(osg::Matrix::lookAt(eye, osg::Vec3d(), osg::Vec3d(0, 0, 1))),
        osg::Transform::ABSOLUTE_RF);
    scene.accept(*visitor);
    visitor->popModelViewMatrix();
    visitor->popProjectionMatrix();
    visitor->popViewport();
}
