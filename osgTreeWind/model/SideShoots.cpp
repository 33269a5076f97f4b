// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/SideShoots.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/base/UnitVectors.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace osgTreeWind {
namespace {

constexpr float spacing = 1.5f;    ///< Leafy wood per side shoot, in lengths of a shoot.
constexpr float shortest = 0.1f;   ///< Least typical length of a shoot, metres.
constexpr int directions = 8;      ///< Number of directions to choose from.
constexpr float stepLength = 0.1f; ///< Distance of places at which leaves are counted, metres.
constexpr float thinning = 0.7f;   ///< Radius of a side shoot / that of the wood that bears it.

/// Counts leafy wood in the cells of a grid.
class LeafyCells {
public:
    LeafyCells(const glm::vec3& low, const glm::vec3& high, float cell)
        : _low(low),
          _cell(std::max(cell, glm::max(high.x - low.x, glm::max(high.y - low.y, high.z - low.z)) / 100.0f)),
          _size(glm::ivec3((high - low) / _cell) + 1),
          _count(static_cast<std::size_t>(_size.x * _size.y * _size.z)) {}

    void add(const glm::vec3& place) {
        if (float* count = at(place))
            *count += 1.0f;
    }
    float count(const glm::vec3& place) { return at(place) ? *at(place) : 0.0f; }

private:
    float* at(const glm::vec3& place) {
        const glm::vec3 off = (place - _low) / _cell;
        const glm::ivec3 cell(off);
        if (glm::min(off.x, glm::min(off.y, off.z)) < 0.0f || cell.x >= _size.x || cell.y >= _size.y ||
            cell.z >= _size.z)
            return nullptr;
        return &_count[static_cast<std::size_t>((cell.z * _size.y + cell.y) * _size.x + cell.x)];
    }

    glm::vec3 _low;
    float _cell;
    glm::ivec3 _size;
    std::vector<float> _count;
};

/// Leafy wood: the points of a line, and the part of it that bears leaves.
struct LeafyLine {
    std::vector<glm::vec3> points;
    BranchPart leafy;
    int unit, level;
    float baseRadius, tipRadius;

    /// Calls visit(place, direction, share of the line) at equal distances along the leafy part.
    template <typename Visit>
    void walk(float step, float first, Visit visit) const {
        float whole = 0.0f;
        for (std::size_t i = 1; i < points.size(); ++i)
            whole += glm::distance(points[i - 1], points[i]);
        float passed = 0.0f, next = leafy.from + first;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const glm::vec3 way = points[i] - points[i - 1];
            const float length = glm::length(way);
            for (; next <= std::min(passed + length, leafy.to); next += step)
                if (length > 0.0f)
                    visit(points[i - 1] + (next - passed) / length * way, way / length, next / whole);
            passed += length;
        }
    }
};

std::vector<LeafyLine> leafyLines(const Skeleton& skeleton) {
    std::vector<LeafyLine> lines;
    const auto add = [&](LeafyLine line) {
        if (line.leafy.to > line.leafy.from)
            lines.push_back(std::move(line));
    };
    auto shoot = skeleton.shoots.begin();
    for (std::size_t i = 0; i < skeleton.units.size(); ++i) {
        const BranchUnit& unit = skeleton.units[i];
        const auto first = skeleton.points.begin() + static_cast<std::ptrdiff_t>(i) * skeleton.ringsPerBranch;
        add({{first, first + skeleton.ringsPerBranch},
             skeleton.leafyUnits[i],
             static_cast<int>(i),
             unit.level,
             unit.baseRadius,
             unit.tipRadius});
        for (; shoot != skeleton.shoots.end() && shoot->unit == static_cast<int>(i); ++shoot) {
            const auto start = skeleton.shootPoints.begin() + static_cast<std::ptrdiff_t>(shoot->first);
            add({{start, start + static_cast<std::ptrdiff_t>(shoot->count)},
                 shoot->leafy,
                 shoot->unit,
                 shoot->level,
                 shoot->baseRadius,
                 shoot->tipRadius});
        }
    }
    return lines;
}

/// Chooses places and directions of side shoots.
class SideShootMaker {
public:
    SideShootMaker(const std::vector<LeafyLine>& lines, const glm::vec3& low, const glm::vec3& high,
                   float length, std::uint32_t seed)
        : _leaves(low, high, 0.6f * length), _crown(low, high, 1.6f * length), _length(length),
          _random(seed) {
        for (const LeafyLine& line : lines)
            line.walk(stepLength, 0.0f, [&](const glm::vec3& place, const glm::vec3&, float) {
                _leaves.add(place);
                _crown.add(place);
            });
    }

    /// Makes the side shoots of a line. @param add called with each shoot and its points.
    template <typename Add>
    void make(const LeafyLine& line, Add add) {
        const float step = spacing * _length;
        const float before = _left;
        int made = 0;
        line.walk(step, before, [&](const glm::vec3& base, const glm::vec3& along, float share) {
            ++made;
            Shoot shoot;
            shoot.unit = line.unit;
            shoot.level = line.level + 1;
            shoot.baseRadius = thinning * glm::mix(line.baseRadius, line.tipRadius, share);
            shoot.tipRadius = 0.6f * shoot.baseRadius;
            shoot.count = 3;
            const glm::vec3 tip = bestTip(base, along),
                            middle = 0.5f * (base + tip) - 0.06f * glm::distance(base, tip) * up;
            const float length = glm::distance(base, middle) + glm::distance(middle, tip);
            shoot.leafy = {0.2f * length, length};
            for (int i = 0; i <= 4; ++i)
                _leaves.add(glm::mix(base, tip, 0.25f * static_cast<float>(i)));
            add(shoot, std::array<glm::vec3, 3>{base, middle, tip});
        });
        _left = before + static_cast<float>(made) * step - (line.leafy.to - line.leafy.from);
    }

private:
    glm::vec3 bestTip(const glm::vec3& base, const glm::vec3& along) {
        const glm::vec3 e1 = perpendicular(along), e2 = glm::cross(along, e1);
        const float turn = glm::two_pi<float>() * _random.uniform();
        glm::vec3 best = base;
        float fewest = 1e9f;
        for (int i = 0; i < directions; ++i) {
            const float around = turn + glm::two_pi<float>() * static_cast<float>(i) / directions;
            const float angle = 0.8f + 0.4f * _random.uniform();
            const glm::vec3 way = math::cos(angle) * along +
                                  math::sin(angle) * (math::cos(around) * e1 + math::sin(around) * e2);
            const float length = _length * (0.7f + 0.6f * _random.uniform());
            const glm::vec3 tip = base + length * way, beyond = tip + 0.4f * _length * way;
            const bool outside = _crown.count(tip) == 0.0f || tip.z < 0.5f;
            const float count = _leaves.count(0.5f * (base + tip)) + 2.0f * _leaves.count(tip) +
                                _leaves.count(beyond) + (outside ? 1000.0f : 0.0f);
            if (count < fewest) {
                fewest = count;
                best = tip;
            }
        }
        return best;
    }

    LeafyCells _leaves, _crown; ///< Fine; coarse, where the crown has leaves before side shoots are added.
    float _length;
    float _left = 0.0f; ///< Length of leafy wood until the next side shoot, metres.
    Random _random;
};

} // namespace

void addSideShoots(Skeleton& skeleton, float length, std::uint32_t seed) {
    const std::vector<LeafyLine> lines = leafyLines(skeleton);
    if (!(length > 0.0f) || lines.empty())
        return;
    glm::vec3 low = lines.front().points.front(), high = low;
    for (const LeafyLine& line : lines)
        for (const glm::vec3& point : line.points) {
            low = glm::min(low, point);
            high = glm::max(high, point);
        }
    SideShootMaker maker(lines, low, high, std::max(length, shortest), seed);
    for (const LeafyLine& line : lines)
        maker.make(line, [&](Shoot shoot, const auto& points) {
            shoot.first = skeleton.shootPoints.size();
            skeleton.shootPoints.insert(skeleton.shootPoints.end(), points.begin(), points.end());
            skeleton.shoots.push_back(shoot);
        });
    std::stable_sort(skeleton.shoots.begin(), skeleton.shoots.end(),
                     [](const Shoot& a, const Shoot& b) { return a.unit < b.unit; });
}

} // namespace osgTreeWind
