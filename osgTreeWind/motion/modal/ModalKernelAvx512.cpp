// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalLanes.h>

namespace osgTreeWind {

__attribute__((flatten)) void stepTreesAvx512(const ModalStep& step) {
    for (int first = 0; first < static_cast<int>(TreeLanes::count); first += laneCount)
        ModalLanes(step, first).run();
}

} // namespace osgTreeWind
