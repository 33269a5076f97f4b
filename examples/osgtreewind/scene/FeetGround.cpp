// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/FeetGround.h>

#include <examples/osgtreewind/scene/Ground.h>

#include <osgTreeWind/places/FunctionGround.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace osgTreeWind;

/// Interpolates between the nearest points with the weights of Franke and Little (modified Shepard's method).
class Surface {
public:
    explicit Surface(const std::vector<glm::dvec3>& points) : _low(points.front()), _high(points.front()) {
        for (const glm::dvec3& point : points) {
            _mean += point.z / static_cast<double>(points.size());
            _low = glm::min(_low, glm::dvec2(point));
            _high = glm::max(_high, glm::dvec2(point));
        }
        const glm::dvec2 size = glm::max(_high - _low, 1.0);
        _cell = 1.5 * std::sqrt(size.x * size.y / static_cast<double>(points.size()));
        _cells = glm::ivec2(glm::min(size / _cell, 4000.0)) + 1;
        _buckets.resize(static_cast<std::size_t>(_cells.x) * static_cast<std::size_t>(_cells.y));
        for (const glm::dvec3& point : points)
            _buckets[bucketOf(cellOf(point))].push_back(point);
    }

    /// Beyond the points, the height at their edge fades into their mean.
    double height(double x, double y) const {
        const glm::dvec2 place = glm::clamp(glm::dvec2(x, y), _low, _high);
        const double beyond = glm::distance(place, glm::dvec2(x, y)),
                     level = beyond / (beyond + 0.5 * glm::distance(_low, _high) + 1.0);
        return glm::mix(between(place), _mean, level);
    }

    glm::dvec2 low() const { return _low; }
    glm::dvec2 high() const { return _high; }
    double cell() const { return _cell; }

private:
    static constexpr std::size_t nearest = 8;
    struct Near {
        double distance, height;
        bool operator<(const Near& other) const { return distance < other.distance; }
    };

    double between(const glm::dvec2& place) const {
        std::vector<Near> found;
        const glm::ivec2 middle = cellOf(place);
        const int last = std::max(_cells.x, _cells.y);
        for (int ring = 0; ring <= last; ++ring) {
            collect(place, middle, ring, found);
            if (found.size() <= nearest)
                continue;
            std::nth_element(found.begin(), found.begin() + nearest, found.end());
            if (found[nearest].distance <= ring * _cell)
                break; // further rings hold no nearer points
        }
        if (found.size() > nearest)
            std::nth_element(found.begin(), found.begin() + nearest, found.end());
        else
            found.push_back({2.0 * std::max_element(found.begin(), found.end())->distance + 1.0, 0.0});
        const double reach = found[std::min(nearest, found.size() - 1)].distance;
        double sum = 0.0, weights = 0.0;
        for (std::size_t i = 0; i < std::min(nearest, found.size() - 1); ++i) {
            const double share =
                std::max(reach - found[i].distance, 1e-9) / (reach * std::max(found[i].distance, 1e-3));
            sum += share * share * found[i].height;
            weights += share * share;
        }
        return sum / weights;
    }

    glm::ivec2 cellOf(const glm::dvec2& place) const {
        return glm::min(glm::ivec2((place - _low) / _cell), _cells - 1);
    }
    std::size_t bucketOf(const glm::ivec2& cell) const {
        return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(_cells.x) +
               static_cast<std::size_t>(cell.x);
    }
    /// Collects the points in a ring of cells around the middle.
    void collect(const glm::dvec2& place, const glm::ivec2& middle, int ring,
                 std::vector<Near>& found) const {
        const glm::ivec2 first = glm::max(middle - ring, 0), last = glm::min(middle + ring, _cells - 1);
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x)
                if (std::max(std::abs(x - middle.x), std::abs(y - middle.y)) == ring)
                    for (const glm::dvec3& point : _buckets[bucketOf({x, y})])
                        found.push_back({glm::distance(place, glm::dvec2(point)), point.z});
    }

    glm::dvec2 _low, _high;
    double _mean = 0.0, _cell;
    glm::ivec2 _cells;
    std::vector<std::vector<glm::dvec3>> _buckets;
};

} // namespace

GroundPtr groundThroughFeet(const ForestDescription& forest) {
    std::vector<glm::dvec3> feet;
    bool isLevel = true;
    for (const TreePlacement& tree : forest.trees) {
        feet.push_back(tree.position);
        isLevel &= std::abs(tree.position.z - forest.origin.z) < 0.001;
    }
    if (isLevel || forest.ground)
        return nullptr;
    const auto surface = std::make_shared<const Surface>(feet);
    const double radius = 0.5 * glm::distance(surface->low(), surface->high());
    const double beyond =
        static_cast<double>(groundRadius(osg::BoundingSphere(osg::Vec3(), static_cast<float>(radius))));
    return std::make_shared<FunctionGround>([surface](double x, double y) { return surface->height(x, y); },
                                            GroundArea{surface->low() - beyond, surface->high() + beyond,
                                                       std::clamp(surface->cell(), 2.0, 16.0)});
}
