// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/options/Offscreen.h>

#include <osg/Light>
#include <osgViewer/Viewer>

#include <string>
#include <vector>

/// Times of frames, one number per frame, milliseconds.
struct BenchTimes {
    std::vector<double> frame;              ///< Whole frames including glFinish.
    std::vector<double> processor;          ///< Processor time of all threads during the frame.
    std::vector<double> update, cull, draw; ///< Measured by osgViewer; draw includes glFinish.
    std::vector<double> gpu;                ///< Measured by osgViewer; empty without timer queries.
};

/// Names of the OpenGL driver.
struct BenchDriver {
    std::string vendor, renderer, version;
    bool hasPipelineStatistics = false; ///< GL_ARB_pipeline_statistics_query.
};

/// Vertical field of view, degrees.
constexpr double benchFieldOfView = 40.0;

/// One of the scenes that are drawn in turns, and its view.
struct BenchVariant {
    osg::ref_ptr<osg::Node> node;
    osg::Matrixd view;
    double fieldOfView = benchFieldOfView;
};

/// Viewer for several scenes under one sun, of which one is drawn at a time.
class BenchViewer {
public:
    /// @param frames maximum number of frames. @param driver is filled in by the first frame.
    BenchViewer(const PictureSize& size, osg::GraphicsContext& context, BenchDriver& driver,
                std::vector<BenchVariant> variants, int frames);

    /// Draws one variant and hides the other variants.
    void draw(std::size_t variant, double time);
    /// Draws a variant and records its times.
    void measure(std::size_t variant, double time);
    /// Recorded times by variant. Draws `variant` a few more times, because timer queries answer late.
    std::vector<BenchTimes> times(std::size_t variant, double time);

private:
    void readStats(const std::vector<unsigned>& frames, BenchTimes& times);

    double _aspect;
    std::vector<BenchVariant> _variants;
    std::vector<BenchTimes> _times;
    std::vector<std::vector<unsigned>> _frames; ///< Numbers of the measured frames, by variant.
    osgViewer::Viewer _viewer;
};

/// View of all trees from the south-west.
osg::Matrixd benchView(const PictureSize& size, const osg::BoundingSphere& bound);
