// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/ScanAxes.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {
namespace {

constexpr std::size_t noCylinder = static_cast<std::size_t>(-1);

double lengthOf(const ScanCylinder& cylinder) {
    return glm::distance(cylinder.start, cylinder.end);
}

/// Makes sections non-increasing (pool adjacent violators): neighbours in wrong order get their mean.
void taper(std::vector<double>& radii, const WoodLine& line) {
    struct Pool {
        double section, length; // section: radius^2
        std::size_t end;
    };
    std::vector<Pool> pools;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        Pool pool{radii[i] * radii[i], line.arc[i + 1] - line.arc[i], i + 1};
        for (; !pools.empty() && pools.back().section < pool.section; pools.pop_back()) {
            const Pool& before = pools.back();
            const double length = pool.length + before.length;
            if (length > 0.0)
                pool.section = (pool.section * pool.length + before.section * before.length) / length;
            pool.length = length;
        }
        pools.push_back(pool);
    }
    std::size_t i = 0;
    for (const Pool& pool : pools)
        for (; i < pool.end; ++i)
            radii[i] = std::sqrt(pool.section);
}

class AxisFinder {
public:
    explicit AxisFinder(const ScanCylinders& cylinders)
        : _cylinders(cylinders), _children(cylinders.size()), _woodLengths(cylinders.size()),
          _next(cylinders.size(), noCylinder), _place(cylinders.size()) {
        for (std::size_t i = 0; i < cylinders.size(); ++i)
            if (cylinders[i].parent < 0)
                _root = i;
            else
                _children[static_cast<std::size_t>(cylinders[i].parent)].push_back(i);
        const std::vector<std::size_t> order = parentsFirst();
        for (auto at = order.rbegin(); at != order.rend(); ++at) {
            _woodLengths[*at] = lengthOf(cylinders[*at]);
            for (const std::size_t child : _children[*at])
                _woodLengths[*at] += _woodLengths[child];
            chooseContinuation(*at);
        }
    }

    std::vector<WoodAxis> axes() {
        addAxis(_root, -1);
        for (std::size_t axis = 0; axis < _axes.size(); ++axis) {
            const std::size_t first = _firsts[axis];
            for (std::size_t at = first; at != noCylinder; at = _next[at])
                for (const std::size_t child : _children[at])
                    if (child != _next[at])
                        addAxis(child, static_cast<int>(axis));
        }
        for (WoodAxis& axis : _axes)
            taper(axis.radii, axis.line);
        return std::move(_axes);
    }

private:
    /// Axis of a cylinder, and its segment of the axis' line.
    struct Place {
        std::size_t axis = 0, stretch = 0;
    };

    std::vector<std::size_t> parentsFirst() const {
        std::vector<std::size_t> order = {_root};
        order.reserve(_cylinders.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            for (const std::size_t child : _children[order[i]])
                order.push_back(child);
        return order;
    }

    void chooseContinuation(std::size_t at) {
        const ScanCylinder& cylinder = _cylinders[at];
        const auto rank = [&](std::size_t child) {
            const double gap = glm::distance(_cylinders[child].start, cylinder.end);
            return std::make_pair(gap < cylinder.radius, _woodLengths[child]);
        };
        for (const std::size_t child : _children[at]) {
            const glm::dvec3 ahead = _cylinders[child].start - cylinder.end;
            const bool isBeside = !rank(child).first && glm::dot(ahead, cylinder.end - cylinder.start) < 0.0;
            if (!isBeside && (_next[at] == noCylinder || rank(child) > rank(_next[at])))
                _next[at] = child;
        }
    }

    /// Adds the axis that begins with cylinder `first`.
    void addAxis(std::size_t first, int parent) {
        const glm::dvec3 foot = _cylinders[_root].start;
        WoodAxis axis;
        axis.parent = parent;
        if (parent < 0)
            axis.line.add(glm::dvec3(0.0));
        else
            startOnParent(axis, first);
        for (std::size_t at = first; at != noCylinder; at = _next[at]) {
            const ScanCylinder& cylinder = _cylinders[at];
            _place[at] = {_axes.size(), axis.radii.size()};
            axis.line.add(cylinder.end - foot);
            axis.radii.push_back(cylinder.radius);
            axis.volume += glm::pi<double>() * cylinder.radius * cylinder.radius * lengthOf(cylinder);
            ++axis.pieces;
        }
        _axes.push_back(std::move(axis));
        _firsts.push_back(first);
    }

    /// Starts an axis on the segment of its parent's line that belongs to the parent of its first cylinder.
    void startOnParent(WoodAxis& axis, std::size_t first) const {
        const ScanCylinder& cylinder = _cylinders[first];
        const auto carrier = static_cast<std::size_t>(cylinder.parent);
        const WoodAxis& parent = _axes[static_cast<std::size_t>(axis.parent)];
        const std::size_t stretch = _place[carrier].stretch;
        const glm::dvec3 start = cylinder.start - _cylinders[_root].start;
        const glm::dvec3 low = parent.line.points[stretch];
        const glm::dvec3 along = parent.line.points[stretch + 1] - low;
        const double square = glm::dot(along, along);
        const double t = square > 0.0 ? glm::clamp(glm::dot(start - low, along) / square, 0.0, 1.0) : 0.0;
        axis.order = parent.order + 1;
        axis.attach = glm::mix(parent.line.arc[stretch], parent.line.arc[stretch + 1], t);
        axis.line.add(low + t * along);
        if (glm::distance(start, axis.line.points.front()) > _cylinders[carrier].radius) {
            axis.line.add(start); // bridges a gap that the parent's wood does not fill
            axis.radii.push_back(cylinder.radius);
        }
    }

    const ScanCylinders& _cylinders;
    std::vector<std::vector<std::size_t>> _children;
    std::vector<double> _woodLengths; ///< Length of wood of each cylinder and its descendants.
    std::vector<std::size_t> _next;   ///< The child that continues the axis.
    std::vector<Place> _place;
    std::size_t _root = 0;
    std::vector<WoodAxis> _axes;
    std::vector<std::size_t> _firsts; ///< First cylinder of each axis.
};

} // namespace

std::vector<WoodAxis> axesOfScan(const ScanCylinders& cylinders) {
    return AxisFinder(cylinders).axes();
}

} // namespace osgTreeWind
