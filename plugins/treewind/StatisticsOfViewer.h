// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/controls/StatisticsLines.h>
#include <osgTreeWind/gpu/EntryGuard.h>

#include <osg/NodeCallback>
#include <osg/ValueObject>
#include <osgGA/EventVisitor>
#include <osgViewer/View>
#include <osgViewer/ViewerEventHandlers>

/// Gives the statistics of a viewer that knows nothing of forests their lines: an event callback of what it
/// has read. An .osgb has it as an osg::NodeCallback, which does nothing.
class StatisticsOfViewer : public osg::NodeCallback {
public:
    void operator()(osg::Node* node, osg::NodeVisitor* visitor) override {
        const auto events = dynamic_cast<osgGA::EventVisitor*>(visitor);
        if (auto* view = events ? dynamic_cast<osgViewer::View*>(events->getActionAdapter()) : nullptr)
            _guard.run("a viewer's statistics have no lines of forests", [&] {
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

    osgTreeWind::EntryGuard _guard;
};
