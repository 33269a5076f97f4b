// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/offscreen/FrameImage.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <osgViewer/Viewer>

#include <iostream>

/// Draws a forest without a display. Succeeds if the image is not empty. Usage: PROGRAM FILE.treewind
int main(int, char** argv) {
    const auto forest = osgTreeWind::readForestFile(argv[1]);
    const auto context = osgTreeWind::createOffscreenContext(64, 64);
    if (!forest || !context) {
        std::cerr << (forest ? context.problems() : forest.problems()).front().text() << '\n';
        return 1;
    }
    osgViewer::Viewer viewer;
    viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    const auto image = osgTreeWind::attachFrameImage(*viewer.getCamera(), *context.value());
    viewer.setSceneData(new osgTreeWind::Forest(forest.value()));
    viewer.getCamera()->setViewMatrixAsLookAt({0, -15, 3}, {0, 0, 3}, {0, 0, 1});
    viewer.realize();
    viewer.frame();
    const bool drawn = image->getColor(32u, 32u) != image->getColor(1u, 63u);
    std::cout << osgTreeWind::offscreenBackendName() << (drawn ? " draws\n" : " draws nothing\n");
    return drawn ? 0 : 1;
}
