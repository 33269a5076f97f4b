// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/drawing/instanced/OcclusionBuffer.h>

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgTreeWind {

struct MeshPart;

/// Sorts the trees of a view and their parts front to back into bins of distance, and tracks which ones hide
/// others. Since crowns overlap, nothing occludes parts of its own bin or of the next one.
class FrontToBackQueue {
public:
    struct Tree {
        std::uint32_t slot;
        std::size_t band;  ///< CullLists::bandOf().
        float pixels;      ///< Height on the screen.
        glm::vec3 toEye{}; ///< From the middle of the tree toward the eye, in the forest's frame.
    };
    /// A part of a tree that is drawn.
    struct Part {
        const MeshPart* mesh;
        std::uint32_t tree; ///< Index of the tree among those that the camera draws with branches.
        float distance;     ///< Of its nearest point from the eye, metres.
        bool isLeaf;
        bool isTestable; ///< False close to the eye: it is visible, and hides nothing.
        OcclusionBuffer::Rectangle place;
    };

    void clear() {
        for (Bin& bin : _bins) {
            bin.trees.clear();
            bin.parts.clear();
        }
        _nextBin = 0;
        _current.clear();
        _previous.clear();
        _occlusion.clear();
    }
    /// Makes a tree that is being visited hide what follows, as a whole.
    void occludeBy(const OcclusionBuffer::Billboard& tree) { _current.trees.push_back(tree); }
    /// What is nearer than the visited bins goes to the next bin. The visit of a tree may insert parts, also
    /// into its own bin. @param distance of its nearest point from the eye, metres.
    void insert(const Tree& tree, float distance) {
        _bins[std::max(_nextBin, binOf(distance))].trees.push_back(tree);
    }
    void insert(const Part& part) { _bins[std::max(_nextBin, binOf(part.distance))].parts.push_back(part); }

    /// Calls visit(tree) and visit(part) once for each tree and part in the bins before `distance`, front to
    /// back. Meanwhile, occlusion() contains those in front. A part hides others if visit(part) returns true.
    template <typename Visit>
    void visitNearerThan(float distance, Visit visit) {
        visitBins(binOf(distance), visit);
    }
    /// Likewise for all remaining ones.
    template <typename Visit>
    void visitAll(Visit visit) {
        visitBins(_bins.size(), visit);
    }
    /// What occludes the next bin.
    const OcclusionBuffer& occlusion() const { return _occlusion; }

private:
    struct Bin {
        std::vector<Tree> trees;
        std::vector<Part> parts;
    };

    /// 0.5 m deep at the eye, 3 m at 60 m.
    static std::size_t binOf(float distance) {
        const float bin = 23.083121f * math::log(1.0f + std::max(distance, 0.0f) / 12.0f);
        return static_cast<std::size_t>(std::min(bin, float(std::tuple_size_v<decltype(_bins)> - 1)));
    }

    template <typename Visit>
    void visitBins(std::size_t end, Visit visit) {
        for (; _nextBin < end; ++_nextBin) {
            Bin& bin = _bins[_nextBin];
            for (const Tree& tree : bin.trees)
                visit(tree);
            for (const Part& part : bin.parts)
                if (visit(part))
                    _current.parts.push_back(part.place);
            for (const OcclusionBuffer::Rectangle& part : _previous.parts)
                _occlusion.add(part);
            for (const OcclusionBuffer::Billboard& tree : _previous.trees)
                _occlusion.add(tree);
            std::swap(_previous, _current);
            _current.clear();
        }
    }

    std::array<Bin, 128> _bins; ///< The last one has no far end.
    std::size_t _nextBin = 0;
    struct Occluders {
        std::vector<OcclusionBuffer::Rectangle> parts;
        std::vector<OcclusionBuffer::Billboard> trees;
        void clear() {
            parts.clear();
            trees.clear();
        }
    } _current, _previous; ///< Of those bins.
    OcclusionBuffer _occlusion;
};

} // namespace osgTreeWind
