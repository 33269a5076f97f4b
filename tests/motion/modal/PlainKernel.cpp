// SPDX-License-Identifier: MIT
// The kernel as compilers without vectors make it.
#define OSGTREEWIND_PLAIN_LANES
#include <osgTreeWind/motion/modal/ModalLanes.h>

namespace osgTreeWind {

void stepTreesPlain(const ModalStep& step);
void stepTreesPlain(const ModalStep& step) {
    for (std::size_t first = 0; first < TreeLanes::count; first += laneCount)
        ModalLanes(step, first).run();
}

} // namespace osgTreeWind
