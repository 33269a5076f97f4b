// SPDX-License-Identifier: MIT
// An OSG program without osgTreeWind that opens a window. It succeeds if the window has the clear colour.
#include <osgViewer/Viewer>

#include <iostream>

struct ReadPixel : osg::Camera::DrawCallback {
    explicit ReadPixel(osg::Vec4ub& pixel) : target(pixel) {}
    void operator()(osg::RenderInfo&) const override {
        glReadPixels(100, 100, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, target.ptr());
    }
    osg::Vec4ub& target;
};

int main() {
    osg::Vec4ub pixel;
    osgViewer::Viewer viewer;
    viewer.setUpViewInWindow(10, 10, 320, 200);
    viewer.getCamera()->setClearColor(osg::Vec4(1, 0, 1, 1));
    viewer.getCamera()->setFinalDrawCallback(new ReadPixel(pixel));
    viewer.setLightingMode(osg::View::NO_LIGHT); // OSG cannot apply lights in a core profile, and says so
    viewer.setSceneData(new osg::Group);
    viewer.realize();
    for (int i = 0; i < 3; ++i)
        viewer.frame();
    viewer.stopThreading();
    std::cout << "pixel " << +pixel.r() << " " << +pixel.g() << " " << +pixel.b() << std::endl;
    return pixel.r() == 255 && pixel.g() == 0 && pixel.b() == 255 ? 0 : 1;
}
