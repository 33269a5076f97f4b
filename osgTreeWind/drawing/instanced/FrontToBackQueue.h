// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/OcclusionBuffer.h>

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// Sorts the trees of a view front to back into bins of distance, and tracks which ones hide others. Since
/// crowns overlap, trees do not occlude trees of their own bin or of the next one.
class FrontToBackQueue {
public:
    struct Tree {
        std::uint32_t slot;
        std::size_t band;  ///< CullLists::bandOf().
        float pixels;      ///< Height on the screen.
        glm::vec3 toEye{}; ///< From the middle of the tree toward the eye, in the forest's frame.
    };

    void clear() {
        for (std::vector<Tree>& trees : _bins)
            trees.clear();
        _nextBin = 0;
        _currentBin.clear();
        _previousBin.clear();
        _occlusion.clear();
    }
    /// @param distance from the eye, metres. A tree nearer than the visited bins goes to the next bin.
    void insert(const Tree& tree, float distance) {
        _bins[std::max(_nextBin, binOf(distance))].push_back(tree);
    }

    /// Calls visit(tree) once for each tree in the bins before `distance`, front to back. During the call,
    /// occlusion() holds the trees in front of it. The visitor returns the billboard of the tree.
    template <typename Visit>
    void visitNearerThan(float distance, Visit visit) {
        visitBins(binOf(distance), visit);
    }
    /// Likewise for all remaining trees.
    template <typename Visit>
    void visitAll(Visit visit) {
        visitBins(_bins.size(), visit);
    }
    /// The visited trees that occlude the next bin.
    const OcclusionBuffer& occlusion() const { return _occlusion; }

private:
    static std::size_t binOf(float distance) {
        constexpr float depth = 6.0f; // metres
        constexpr float last = std::tuple_size_v<decltype(_bins)> - 1;
        return static_cast<std::size_t>(std::clamp(distance / depth, 0.0f, last));
    }

    template <typename Visit>
    void visitBins(std::size_t end, Visit visit) {
        for (; _nextBin < end; ++_nextBin) {
            for (const Tree& tree : _bins[_nextBin])
                _currentBin.push_back(visit(tree));
            for (const OcclusionBuffer::Billboard& billboard : _previousBin)
                _occlusion.add(billboard);
            _previousBin.swap(_currentBin);
            _currentBin.clear();
        }
    }

    std::array<std::vector<Tree>, 128> _bins; ///< The last one has no far end.
    std::size_t _nextBin = 0;
    std::vector<OcclusionBuffer::Billboard> _currentBin, _previousBin;
    OcclusionBuffer _occlusion;
};

} // namespace osgTreeWind
