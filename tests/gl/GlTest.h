// SPDX-License-Identifier: MIT
#pragma once

#include <tests/MessageCollector.h>
#include <tests/gl/LaterOpenGL.h>

#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <osg/Image>
#include <osg/Vec4ub>
#include <osgViewer/Viewer>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

/// Resident memory of this program, bytes.
std::size_t residentMemory();
/// Bytes it may have grown by when what it made is gone again; ASan keeps freed memory for a while.
#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t keptMemory = std::size_t(1) << 30;
#else
constexpr std::size_t keptMemory = std::size_t(8) << 20;
#endif

/// Whether OSG has OpenGL's fixed function. Without it, OSG draws shapes that have no program in one colour,
/// and the shaders of osgShadow::ShadowMap do not compile.
constexpr bool hasFixedFunction = osgTreeWind::osgProfile == osgTreeWind::ContextProfile::Compatibility;

/// A test that draws without a display, in the profile that OSG is built for. Whatever OSG says at NOTICE or
/// above (OpenGL errors, shader logs, failed frame buffer objects, warnings of ours) fails it, unless the
/// test takes the message and judges it.
class GlTest : public ::testing::Test {
protected:
    GlTest();
    ~GlTest() override;

    /// A fresh context and a single-threaded viewer that draws into image(). Replaces the ones before.
    void open(int width, int height, int samples = 0);
    /// As open(), but what was opened before stays if it has this size and these samples.
    void reopen(int width, int height, int samples = 0);
    osgViewer::Viewer& viewer() { return *_viewer; }
    osg::GraphicsContext& context() { return *_context; }
    /// RGBA bytes, row 0 at the bottom; refilled by each frame().
    osg::Image& image() { return *_image; }
    osg::Vec4ub pixel(int x, int y) const;

    /// Draws one frame at a simulation time (s), and fails on anything said meanwhile.
    void frame(double time);

    /// Opens, draws that many frames 1/25 s apart from 0, and returns a copy of the last. The camera looks
    /// along +y from 2.5 radii before the node's bounds, 40 degrees high, z up, on black.
    osg::ref_ptr<osg::Image> render(osg::Node* node, int width, int height, int frames = 1);

    /// What OSG said since the last look; the test has then dealt with it.
    std::string takeMessages();

    void TearDown() override;

private:
    osg::ref_ptr<MessageCollector> _collector;
    osg::ref_ptr<osg::NotifyHandler> _formerHandler;
    osg::NotifySeverity _formerLevel;
    osg::ref_ptr<osg::GraphicsContext> _context;
    osg::ref_ptr<osgViewer::Viewer> _viewer;
    osg::ref_ptr<osg::Image> _image;
    int _samples = 0;
};
