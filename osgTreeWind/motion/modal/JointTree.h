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

/// A tree as stiff links on springs, with masses and drag at points of them: what its modes are worked out
/// from. SI units, the tree's own frame at rest (Z up).
struct JointTree {
    /// A link turns about two axes at its base.
    struct Link {
        int parent = -1; ///< Index; -1 for one that stands on the ground. Always < own index.
        glm::dvec3 base{0.0};
        std::array<glm::dvec3, 2> axes{glm::dvec3(0, 1, 0),
                                       glm::dvec3(-1, 0, 0)}; ///< Unit length, across it.
        double stiffness = 1.0;                               ///< Of either axis, N m/rad.
    };

    /// A point of a link.
    struct Point {
        std::size_t link = 0;
        glm::dvec3 place{0.0};
        /// From the base of its link, how far it moves as that link's own joint turns; along the link, and
        /// less than its distance where the link stands for bending wood.
        glm::dvec3 lever{0.0};
        double mass = 0.0;      ///< kg
        double woodDrag = 0.0;  ///< CdA of bare wood, m^2.
        double leafDrag = 0.0;  ///< CdA of leaves in a wind of 10 m/s, m^2.
        double stillDrag = 0.0; ///< CdA of leaves that move through still air, m^2.
    };

    std::vector<Link> links;
    std::vector<Point> points;

    /// Number of joint angles: two a link, 2 * link + axis.
    std::size_t jointCount() const { return 2 * links.size(); }
    /// Displacement of a point per angle of a joint of a link that carries it.
    glm::dvec3 displacement(const Point& point, std::size_t link, std::size_t axis) const;
};

/// The joints of a tree model: a link a unit, with the axes, the springs and the loads of UnitLoads.h.
/// Wood moves as a bent beam does within its own unit, so that a pole of one unit has its pace within 2 %.
/// @param leaves share of its leaves that the tree bears, 0 bare to 1.
JointTree makeJointTree(const TreeModel& model, const TreeScale& scale, const Species& species,
                        float leaves = 1.0f);

} // namespace osgTreeWind
