// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/DragPatches.h>

#include <glm/geometric.hpp>

namespace osgTreeWind {

namespace {

/// Drag area and its first moment.
struct Drag {
    double area = 0.0;
    glm::dvec3 moment{0.0};

    void add(const Drag& other) {
        area += other.area;
        moment += other.moment;
    }
    Drag without(const Drag& other) const { return {area - other.area, moment - other.moment}; }
};

/// Decrease of the spread (area times squared distance from the centre) when a patch is split in two.
double spreadReduction(const Drag& a, const Drag& b) {
    if (!(a.area > 0.0) || !(b.area > 0.0))
        return 0.0;
    const glm::dvec3 apart = a.moment / a.area - b.moment / b.area;
    return a.area * b.area / (a.area + b.area) * glm::dot(apart, apart);
}

} // namespace

std::vector<std::size_t> dragPatches(const JointTree& tree, std::size_t count) {
    const std::size_t links = tree.links.size();
    const auto parent = [&](std::size_t i) { return static_cast<std::size_t>(tree.links[i].parent); };
    std::vector<Drag> own(links);
    for (const JointTree::Point& point : tree.points) {
        const double area = point.woodDrag + point.leafDrag;
        own[point.link].add({area, area * point.place});
    }
    std::vector<std::size_t> patch(links, 0);
    for (std::size_t made = 1; made < count; ++made) {
        std::vector<Drag> carried = own; // of each link and its descendants within its patch
        std::vector<Drag> whole(made);
        for (std::size_t i = links; i-- > 0;) {
            const bool goesOn = tree.links[i].parent >= 0 && patch[parent(i)] == patch[i];
            (goesOn ? carried[parent(i)] : whole[patch[i]]).add(carried[i]);
        }
        std::size_t cut = links;
        double best = 0.0;
        for (std::size_t i = 0; i < links; ++i) {
            const double gain = spreadReduction(carried[i], whole[patch[i]].without(carried[i]));
            if (gain > best * (1.0 + 1e-9)) {
                best = gain;
                cut = i;
            }
        }
        if (cut == links)
            break;
        const std::size_t old = patch[cut];
        patch[cut] = made;
        for (std::size_t i = cut + 1; i < links; ++i)
            if (tree.links[i].parent >= 0 && patch[i] == old && patch[parent(i)] == made)
                patch[i] = made;
    }
    return patch;
}

} // namespace osgTreeWind
