// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/LeafClusters.h>

#include <array>
#include <vector>

namespace osgTreeWind {

/// How a crown shades itself: the leaf area of its clusters on a grid over the tree, and what it lets through
/// toward the sky and the sun, T = exp(-G L), L being the leaf area met per area across the way (Monsi and
/// Saeki 1953).
class CrownShade {
public:
    static constexpr float projection = 0.5f; ///< G, of leaves that face all ways alike.

    /// Of a crown, m^2 over a m^2 of the ground below it; leaf cards of the thesis' trees would be more.
    static constexpr float mostLeafArea = 5.0f;

    /// Light at a place in the tree, each 1 in the open.
    struct Light {
        glm::vec3 above{1.0f}; ///< What comes from +x, +y and +z.
        glm::vec3 below{1.0f}; ///< What comes from -x, -y and -z.
        float sky = 1.0f;      ///< What comes of a sky that is bright above and dim below.
    };

    /// A place without foliage, all in the open.
    CrownShade() = default;
    /// @param coverage share of a cluster's quads that is leaf.
    CrownShade(const std::vector<LeafCluster>& leaves,
               const std::array<LeafVertex, verticesPerLeafCluster>& mesh, float coverage);

    Light at(const glm::vec3& point) const;
    /// Out of the ellipsoid that the anchors of the leaves fill; unit length.
    glm::vec3 outward(const glm::vec3& point) const;

private:
    static constexpr int cells = 16, nodes = cells + 1, directions = 14;
    using Depths = std::array<float, directions>; ///< L toward each direction.

    static glm::ivec3 direction(std::size_t index);
    void spread(const glm::vec3& point, float area, std::vector<float>& areas) const;
    void sum(const std::vector<float>& density, std::size_t direction);

    glm::vec3 _middle{0.0f, 0.0f, -1.0f}, _halfAxes{1.0f}; ///< Of the ellipsoid.
    glm::vec3 _low{0.0f}, _cell{1.0f};                     ///< Of the grid, metres.
    std::vector<Depths> _depths;                           ///< Of the nodes of the grid, x fastest.
};

} // namespace osgTreeWind
