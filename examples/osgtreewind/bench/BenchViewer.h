// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/options/Offscreen.h>

#include <osg/Light>
#include <osgViewer/Viewer>

#include <string>
#include <vector>

/// How a frame spent its time; a number a frame, milliseconds.
struct BenchTimes {
    std::vector<double> frame;              ///< Whole frames, up to the end of the driver's work (glFinish).
    std::vector<double> processor;          ///< Of all threads of the process in that time.
    std::vector<double> update, cull, draw; ///< What osgViewer measured; draw includes the glFinish.
    std::vector<double> gpu;                ///< Likewise; empty where there are no timer queries.
};

/// What OpenGL says of itself.
struct BenchDriver {
    std::string vendor, renderer, version;
};

/// One of the scenes that are drawn in turns, and where it is looked at from.
struct BenchVariant {
    osg::ref_ptr<osg::Node> node;
    osg::Matrixd view;
};

/// A viewer over several scenes below one sun, each drawn by itself.
class BenchViewer {
public:
    /// @param frames that are going to be drawn, at most. @param driver is filled in by the first of them.
    BenchViewer(const PictureSize& size, osg::GraphicsContext& context, BenchDriver& driver,
                std::vector<BenchVariant> variants, int frames);

    /// Draws a variant while all others are hidden.
    void draw(std::size_t variant, double time);
    /// The same, timed for times().
    void measure(std::size_t variant, double time);
    /// Of the frames measured, by variant. Draws one of them some more, as timer queries answer late.
    std::vector<BenchTimes> times(std::size_t variant, double time);

private:
    void readStats(const std::vector<unsigned>& frames, BenchTimes& times);

    std::vector<BenchVariant> _variants;
    std::vector<BenchTimes> _times;
    std::vector<std::vector<unsigned>> _frames; ///< Numbers of those measured, by variant.
    osgViewer::Viewer _viewer;
};

/// Vertical, degrees.
constexpr double benchFieldOfView = 40.0;

/// Where the stages look at their trees from: from the south-west, all of them in view.
osg::Matrixd benchView(const PictureSize& size, const osg::BoundingSphere& bound);
