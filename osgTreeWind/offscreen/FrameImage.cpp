// SPDX-License-Identifier: MIT
#include <osgTreeWind/offscreen/FrameImage.h>

#include <algorithm>

namespace osgTreeWind {

osg::ref_ptr<osg::Image> attachFrameImage(osg::Camera& camera, osg::GraphicsContext& context, int samples) {
    const osg::GraphicsContext::Traits& traits = *context.getTraits();
    return attachFrameImage(camera, context, traits.width, traits.height, samples);
}

osg::ref_ptr<osg::Image> attachFrameImage(osg::Camera& camera, osg::GraphicsContext& context, int width,
                                          int height, int samples) {
    const unsigned int multisamples = samples > 1 ? samples : 0;

    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(width, height, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    image->setInternalTextureFormat(GL_RGBA8);
    std::fill_n(image->data(), image->getTotalSizeInBytes(), static_cast<unsigned char>(0));

    camera.setGraphicsContext(&context);
    camera.setViewport(0, 0, width, height);
    camera.setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera.attach(osg::Camera::COLOR_BUFFER, image.get(), multisamples, multisamples);
    return image;
}

} // namespace osgTreeWind
