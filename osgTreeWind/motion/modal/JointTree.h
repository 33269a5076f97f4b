// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/species/Species.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// Multibody model of a tree: rigid links on rotational springs, with point masses and drag. The input of
/// modal analysis. SI units, the tree's own frame at rest (Z up).
struct JointTree {
    /// A link turns about two axes at its base.
    struct Link {
        int parent = -1; ///< Index, less than its own; -1 for a link on the ground.
        glm::dvec3 base{0.0};
        /// Unit length, perpendicular to the link.
        std::array<glm::dvec3, 2> axes{glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0)};
        double stiffness = 1.0; ///< About each axis, N m/rad.
    };

    /// A point mass or drag area on a link.
    struct Point {
        std::size_t link = 0;
        glm::dvec3 place{0.0};
        /// Displacement direction and lever of the point about its own link's joint, along the link; shorter
        /// than the distance where the link represents bending wood.
        glm::dvec3 lever{0.0};
        double mass = 0.0;      ///< kg
        double woodDrag = 0.0;  ///< CdA of wood, m^2.
        double leafDrag = 0.0;  ///< CdA of leaves at 10 m/s, m^2.
        double stillDrag = 0.0; ///< CdA of leaves that move through still air, m^2.
    };

    std::vector<Link> links;
    std::vector<Point> points;

    /// Number of joint angles, two per link; the index is 2 * link + axis.
    std::size_t jointCount() const { return 2 * links.size(); }
    /// Displacement of a point per radian of a joint. @param link carries the point.
    glm::dvec3 displacement(const Point& point, std::size_t link, std::size_t axis) const;
};

/// Builds the joints of a tree model: one link per unit, with the stiffness and loads of UnitLoads.h. Wood
/// within a unit moves like a bent beam, so that the frequency of a one-unit pole is accurate to 2 %.
/// @param leaves share of its leaves that the tree bears, 0 (bare) to 1.
JointTree makeJointTree(const TreeModel& model, const TreeScale& scale, const Species& species,
                        float leaves = 1.0f);

} // namespace osgTreeWind
