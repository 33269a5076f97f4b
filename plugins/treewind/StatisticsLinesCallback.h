// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/controls/StatisticsLines.h>
#include <osgTreeWind/gpu/ExceptionGuard.h>

#include <osg/NodeCallback>
#include <osg/ValueObject>
#include <osgGA/EventVisitor>
#include <osgViewer/View>
#include <osgViewer/ViewerEventHandlers>

/// An event callback of forests that are read through osgDB. It adds the lines of forests to the statistics
/// of the viewer, which need not link osgTreeWind. OSG writes it as an osg::NodeCallback, which does nothing.
class StatisticsLinesCallback : public osg::NodeCallback {
public:
    void operator()(osg::Node* node, osg::NodeVisitor* visitor) override {
        const auto events = dynamic_cast<osgGA::EventVisitor*>(visitor);
        if (auto* view = events ? dynamic_cast<osgViewer::View*>(events->getActionAdapter()) : nullptr)
            _guard.run("the viewer's statistics have no lines of forests", [&] {
                for (const osg::ref_ptr<osgGA::EventHandler>& handler : view->getEventHandlers())
                    addOnce(dynamic_cast<osgViewer::StatsHandler*>(handler.get()));
            });
        traverse(node, visitor);
    }

private:
    static void addOnce(osgViewer::StatsHandler* handler) {
        bool added = false;
        if (!handler || handler->getUserValue("osgTreeWind lines", added))
            return;
        handler->setUserValue("osgTreeWind lines", true);
        osgTreeWind::addStatisticsLines(*handler);
    }

    osgTreeWind::ExceptionGuard _guard;
};
