// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/JointTree.h>

#include <glm/geometric.hpp>

namespace osgTreeWind {

bool JointTree::carries(std::size_t carrier, std::size_t link) const {
    int i = static_cast<int>(link);
    while (i > static_cast<int>(carrier))
        i = links[static_cast<std::size_t>(i)].parent;
    return i == static_cast<int>(carrier);
}

glm::dvec3 JointTree::displacement(const Point& point, std::size_t link, std::size_t axis) const {
    const glm::dvec3 arm = point.link == link ? point.lever : point.place - links[link].base;
    return glm::cross(links[link].axes[axis], arm);
}

} // namespace osgTreeWind
