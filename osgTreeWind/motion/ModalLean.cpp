// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/ModalLean.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

std::vector<glm::vec2> modalLeans(const JointTree& tree, const ModalShape& shape, double height,
                                  double power) {
    std::vector<glm::dvec2> sums(shape.modes.size(), glm::dvec2(0.0));
    double squares = 0.0;
    for (const JointTree::Point& point : tree.points) {
        const double leaning = std::pow(std::max(point.place.z / height, 0.0), power);
        const double weight = (point.woodDrag + point.leafDrag) * leaning;
        squares += weight * leaning;
        for (int c = static_cast<int>(point.link); c >= 0; c = tree.links[static_cast<std::size_t>(c)].parent)
            for (std::size_t axis = 0; axis < 2; ++axis) {
                const auto carrier = static_cast<std::size_t>(c);
                const glm::dvec2 moved = weight * glm::dvec2(tree.displacement(point, carrier, axis));
                const float* angles = shape.poses.data() + (2 * carrier + axis) * shape.columns();
                for (std::size_t k = 0; k < sums.size(); ++k)
                    sums[k] += static_cast<double>(angles[k]) * moved;
            }
    }
    std::vector<glm::vec2> leans;
    for (const glm::dvec2& sum : sums)
        leans.emplace_back(squares > 0.0 ? sum / squares : glm::dvec2(0.0));
    return leans;
}

} // namespace osgTreeWind
