// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/ModalLanes.h>

namespace osgTreeWind {

__attribute__((flatten)) void stepTreesAvx2(const ModalStep& step) {
    ModalLanes(step).run();
}

} // namespace osgTreeWind
