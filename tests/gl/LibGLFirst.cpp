// SPDX-License-Identifier: MIT
// A program linked the wrong way, with libGL before libOSMesa: it must be told so and not crash.
#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <osg/GL>

#include <iostream>

int main() {
    glGetString(GL_VERSION); // so that the linker keeps libGL
    const auto made = osgTreeWind::createOffscreenContext(8, 8);
    std::cout << (made ? "made a context" : made.problems().front().message) << std::endl;
}
