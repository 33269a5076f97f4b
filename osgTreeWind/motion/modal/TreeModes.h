// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/JointTree.h>

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// A way in which a whole tree sways freely.
struct TreeMode {
    double speed = 0.0;         ///< Circular frequency without weight, rad/s.
    double weightShare = 0.0;   ///< What weight takes of the stiffness: W / U; below 0 where the tree hangs.
    std::vector<double> angles; ///< Angle of each joint; the mode's kinetic energy at speed 1 is 1/2.
};

/// Its mass against turns of its joints: M_ij = sum of m (a_i x r_i).(a_j x r_j) over the points that both
/// joints carry. Entries are there only where one joint carries the other.
class JointMasses {
public:
    explicit JointMasses(const JointTree& tree);

    /// M x. Both have jointCount() elements.
    std::vector<double> times(const std::vector<double>& x) const;

private:
    friend std::vector<TreeMode> slowestModes(const JointTree& tree, std::size_t count);
    struct Block {
        std::size_t link, carrier;
        double m[2][2];
    };
    std::size_t _size;
    std::vector<Block> _blocks; ///< By link, from itself down to the ground.
};

/// The slowest modes of a tree, slowest first: K phi = M phi omega^2 with phi^T M phi = 1.
/// Exact for up to 36 links; beyond that the slower half is exact to 1e-6 and the rest near it (a Krylov
/// space of K^-1 M).
/// @param count at most jointCount().
std::vector<TreeMode> slowestModes(const JointTree& tree, std::size_t count);

} // namespace osgTreeWind
