// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace osgTreeWind {

/// What the crowns around each tree of a forest leave of the light, sun and sky alike. A tree that comes,
/// changes or goes costs as much as it has neighbours. Changed in update only.
class NeighbourShade {
public:
    /// A crown as others see it: a level disc half way up the crown. Metres, the forest's frame.
    struct Crown {
        glm::vec3 foot{0.0f};
        float height = 0.0f, radius = 0.0f;
        float density = 0.0f; ///< Of the light that meets it, the share that it keeps, 0 to 1.
    };
    /// Shares, each 1 in the open.
    struct Left {
        float atFoot = 1.0f, atTop = 1.0f;
    };

    /// A tree is here now, wherever it was; numbers are small.
    void put(std::uint32_t number, const Crown& crown);
    void take(std::uint32_t number);
    /// Works out what changes since the last call have made of it.
    void update();
    /// As of the last update(); of a tree that is there.
    Left left(std::uint32_t number) const { return _trees[number].left; }

private:
    struct Tree {
        Crown crown;
        Left left;
        bool here = false, stale = false;
    };
    using Cell = std::vector<std::uint32_t>;

    static glm::ivec2 cellAt(const glm::vec3& place);
    static std::uint64_t keyOf(const glm::ivec2& cell);
    template <typename Use>
    void around(const glm::vec3& place, const Use& use) const;
    void markAround(const glm::vec3& place);
    float leftAt(std::uint32_t number, float height) const;

    std::vector<Tree> _trees; ///< By number.
    std::vector<std::uint32_t> _stale;
    std::unordered_map<std::uint64_t, Cell> _cells;
};

} // namespace osgTreeWind
