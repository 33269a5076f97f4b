// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/JointTree.h>

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// A natural mode of a tree.
struct TreeMode {
    double omega = 0.0;         ///< Angular frequency without weight, rad/s.
    double weightShare = 0.0;   ///< Share of stiffness that weight takes, W / U; < 0 if the tree hangs.
    std::vector<double> angles; ///< Mode shape: angle of each joint; normalized to unit modal mass.
};

/// Mass matrix of a tree in its joint angles: M_ij = sum of m (a_i x r_i).(a_j x r_j) over the points that
/// both joints carry. Sparse: nonzero where one joint carries the other.
class JointMasses {
public:
    explicit JointMasses(const JointTree& tree);

    /// M x. Both have jointCount() elements.
    std::vector<double> times(const std::vector<double>& x) const;

private:
    friend std::vector<TreeMode> lowestModes(const JointTree& tree, std::size_t count);
    struct Block {
        std::size_t link, carrier;
        double m[2][2];
    };
    std::size_t _size;
    std::vector<Block> _blocks; ///< By link, from the link itself down to the ground.
};

/// The lowest modes of a tree, by rising frequency: K phi = M phi omega^2 with phi^T M phi = 1, computed in a
/// Krylov space of K^-1 M. Exact for up to 36 links; beyond that the lower half is exact to 1e-6, and the
/// rest is approximate. @param count at most jointCount().
std::vector<TreeMode> lowestModes(const JointTree& tree, std::size_t count);

} // namespace osgTreeWind
