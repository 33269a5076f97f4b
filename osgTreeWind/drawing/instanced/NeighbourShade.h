// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace osgTreeWind {

/// Share of the light of sun and sky that reaches each tree past the crowns of its neighbours. The cost of a
/// change grows with the number of neighbours. Changed in update only.
class NeighbourShade {
public:
    /// A crown as a horizontal disc that shades neighbours. Metres, the forest's frame.
    struct Crown {
        glm::vec3 foot{0.0f};
        float height = 0.0f, radius = 0.0f;
        float density = 0.0f; ///< Share of the light that the crown absorbs, 0 to 1.
    };
    /// Shares of the light; 1 for a solitary tree.
    struct Light {
        float atFoot = 1.0f, atTop = 1.0f;
    };

    /// Adds a tree, or replaces the one in this slot. Memory grows with the largest slot.
    void insert(std::uint32_t slot, const Crown& crown);
    void remove(std::uint32_t slot);
    /// Recomputes the light of the trees around all changes since the last call.
    void update();
    /// The result of the last update() for a tree that is present.
    Light light(std::uint32_t slot) const { return _trees[slot].light; }

private:
    struct Tree {
        Crown crown;
        Light light;
        bool isPresent = false, isStale = false;
    };
    using Cell = std::vector<std::uint32_t>;

    static glm::ivec2 cellAt(const glm::vec3& place);
    static std::uint64_t keyOf(const glm::ivec2& cell);
    template <typename Use>
    void forEachNear(const glm::vec3& place, const Use& use) const;
    void markNeighboursStale(const glm::vec3& place);
    float lightAt(std::uint32_t slot, float height) const;

    std::vector<Tree> _trees; ///< By slot.
    std::vector<std::uint32_t> _stale;
    std::unordered_map<std::uint64_t, Cell> _cells;
};

} // namespace osgTreeWind
