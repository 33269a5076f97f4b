// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalLanes.h>

namespace osgTreeWind {

OSGTREEWIND_FLATTEN void stepTreesAvx2(const ModalStep& step) {
    for (std::size_t first = 0; first < TreeLanes::count; first += laneCount)
        ModalLanes(step, first).run();
}

} // namespace osgTreeWind
