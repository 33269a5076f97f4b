// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>

#include <osgTreeWind/offscreen/FrameImage.h>
#include <osgTreeWind/system/Memory.h>

#include <osg/Version>

#ifdef __GLIBC__
#include <dlfcn.h>
#include <malloc.h>
#endif

#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <stdexcept>
#include <utility>

std::size_t residentMemory() {
    return static_cast<std::size_t>(osgTreeWind::residentBytes());
}

GlTest::GlTest()
    : _collector(new MessageCollector), _formerHandler(osg::getNotifyHandler()),
      _formerLevel(osg::getNotifyLevel()) {
    osg::setNotifyHandler(_collector);
    osg::setNotifyLevel(osg::NOTICE);
#ifdef __GLIBC__
    [[maybe_unused]] static const bool printed = [] {
        Dl_info info{};
        dladdr(reinterpret_cast<void*>(&osgGetVersion), &info);
        std::cout << "libosg: " << std::filesystem::canonical(info.dli_fname).string() << std::endl;
        return true;
    }();
    mallopt(M_PERTURB, 0xA5); // what is read after it was freed is not what it was
#endif
}

std::string GlTest::takeMessages() {
    std::string messages = _collector->take();
    if (hasFixedFunction)
        return messages;
    // OSG complains about lights, fog and the like of a scene.
    static const std::regex unsupported("Warning: [A-Za-z]+::apply\\(State&\\) - (is )?not supported\\.\n"
                                        "|Warning: detected OpenGL error 'invalid enumerant' after applying "
                                        "GLMode 0x(c6[0-3]|de1|b50|400[0-7])\n");
    return std::regex_replace(messages, unsupported, "");
}

GlTest::~GlTest() {
    osg::setNotifyLevel(_formerLevel);
    osg::setNotifyHandler(_formerHandler);
}

void GlTest::open(int width, int height, int samples) {
    _viewer = nullptr;
    _context = nullptr;
    auto made = osgTreeWind::createOffscreenContext(width, height);
    if (!made)
        throw std::runtime_error(made.problems().front().message);
    _context = made.value();
    _context->getState()->setCheckForGLErrors(osg::State::ONCE_PER_ATTRIBUTE);
    _viewer = new osgViewer::Viewer;
    _viewer->setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    _viewer->getCamera()->setClearColor(osg::Vec4(0, 0, 0, 1));
    _samples = samples;
    _image = osgTreeWind::attachFrameImage(*_viewer->getCamera(), *_context, samples);
}

void GlTest::reopen(int width, int height, int samples) {
    if (!_viewer || _image->s() != width || _image->t() != height || _samples != samples)
        open(width, height, samples);
}

osg::Vec4ub GlTest::pixel(int x, int y) const {
    const unsigned char* const bytes = _image->data(x, y);
    return osg::Vec4ub(bytes[0], bytes[1], bytes[2], bytes[3]);
}

void GlTest::frame(double time) {
    _viewer->frame(time);
    EXPECT_EQ(takeMessages(), "") << "said while drawing the frame at " << time << " s";
}

osg::ref_ptr<osg::Image> GlTest::render(osg::Node* node, int width, int height, int frames) {
    open(width, height);
    _viewer->setSceneData(node);
    const osg::BoundingSphere bound = node->getBound();
    osg::Camera& camera = *_viewer->getCamera();
    camera.setProjectionMatrixAsPerspective(40, double(width) / height, 1, 100);
    camera.setViewMatrixAsLookAt(bound.center() - osg::Vec3(0, 2.5f * bound.radius(), 0), bound.center(),
                                 osg::Vec3(0, 0, 1));
    for (int i = 0; i < frames; ++i)
        frame(i / 25.0);
    return new osg::Image(*_image, osg::CopyOp::DEEP_COPY_ALL);
}

void GlTest::TearDown() {
    _viewer = nullptr;
    _context = nullptr;
    EXPECT_EQ(takeMessages(), "") << "said outside of frames";
}
