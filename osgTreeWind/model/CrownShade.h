// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/LeafClusters.h>

#include <array>
#include <vector>

namespace osgTreeWind {

/// Self-shading of a crown. The leaf area of the clusters on a grid over the tree gives the transmission
/// toward the sky and the sun, T = exp(-k L), where L is the leaf area per area perpendicular to the
/// direction (Monsi and Saeki 1953). k = G c sqrt(1 - s): leaves are clumped (c, Chen and Cihlar 1995), and
/// scatter a share s of the light onward (Goudriaan 1977).
class CrownShade {
public:
    static constexpr float projection = 0.5f; ///< G of randomly oriented leaves.
    static constexpr float clumping = 0.9f;   ///< c of broadleaved and of coniferous crowns.
    static constexpr float scattering = 0.2f; ///< s of green leaves in visible light.

    /// Upper limit of the crown's leaf area index, m^2/m^2; leaf cards of the thesis' trees would exceed it.
    static constexpr float maxLeafArea = 5.0f;

    /// Light at a place in the tree, each 1 in the open.
    struct Light {
        glm::vec3 above{1.0f}; ///< From +x, +y and +z.
        glm::vec3 below{1.0f}; ///< From -x, -y and -z.
        float sky = 1.0f;      ///< From the sky.
        float ground = 1.0f;   ///< From the ground.
    };

    /// A crown without leaves, which casts no shade.
    CrownShade() = default;
    /// @param coverage share of the area of a cluster's quads that is leaf.
    CrownShade(const std::vector<LeafCluster>& leaves,
               const std::array<LeafVertex, verticesPerLeafCluster>& mesh, float coverage);

    Light at(const glm::vec3& point) const;
    /// Unit normal of the ellipsoid around the anchors of the leaves.
    glm::vec3 outward(const glm::vec3& point) const;

private:
    static constexpr int cells = 16, nodes = cells + 1, directions = 14;
    using Depths = std::array<float, directions>; ///< L in each direction.

    static glm::ivec3 direction(std::size_t index);
    void addArea(const glm::vec3& point, float area, std::vector<float>& areas) const;
    void integrate(const std::vector<float>& density, std::size_t direction);

    glm::vec3 _middle{0.0f, 0.0f, -1.0f}, _halfAxes{1.0f}; ///< Of the ellipsoid.
    glm::vec3 _low{0.0f}, _cell{1.0f};                     ///< Corner and cell size of the grid, metres.
    std::vector<Depths> _depths;                           ///< Per grid node, x fastest.
};

} // namespace osgTreeWind
