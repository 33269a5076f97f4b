// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/JoinedSkin.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/UnitVectors.h>
#include <osgTreeWind/model/BranchCollar.h>
#include <osgTreeWind/model/SkinParts.h>
#include <osgTreeWind/model/SkinPlan.h>
#include <osgTreeWind/model/StemFoot.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <utility>

namespace osgTreeWind {
namespace {

constexpr float limbLength = 2.0f;       ///< Distance over which limbs thin from the stem, over its radius.
constexpr float collarDepth = 0.98f;     ///< Collars begin below the bark, at this share of its radius.
constexpr float minRingDistance = 0.25f; ///< Smallest distance of the rings after a collar, in intervals.

/// A cross-section of a branch.
struct CrossSection {
    glm::vec3 centre, tangent;
    float radius;
};

/// @param place in intervals between the unit's points.
CrossSection sectionAt(const Skeleton& skeleton, std::size_t unit, float place) {
    const int ring = glm::clamp(static_cast<int>(place), 0, skeleton.ringsPerBranch - 2);
    const float part = place - static_cast<float>(ring);
    const glm::vec3 tangent = skeleton.tangent(unit, ring);
    return {glm::mix(skeleton.point(unit, ring), skeleton.point(unit, ring + 1), part),
            directionOr(glm::mix(tangent, skeleton.tangent(unit, ring + 1), part), tangent),
            glm::mix(skeleton.radius(unit, ring), skeleton.radius(unit, ring + 1), part)};
}

/// Orientation of a ring: the axis, and the direction of its first vertex.
struct Frame {
    glm::vec3 tangent, first;

    explicit Frame(const glm::vec3& along) : tangent(along), first(perpendicular(along)) {}
    glm::vec3 outward(float angle) const {
        return cosine(angle) * first + sine(angle) * glm::cross(tangent, first);
    }
    /// Rotates the frame by the smallest angle to a new tangent, so that successive rings are not twisted.
    void follow(const glm::vec3& next) {
        first -= (tangent + next) * (glm::dot(first, next) / glm::max(1.0f + glm::dot(tangent, next), 1e-3f));
        first = directionOr(first - next * glm::dot(first, next), perpendicular(next));
        tangent = next;
    }
};

class SkinMaker {
public:
    SkinMaker(const Skeleton& skeleton, float tolerance)
        : _skeleton(skeleton), _plans(planSkin(skeleton, tolerance)), _foot(skeleton) {}

    BranchSkin make() {
        _ends.reserve(_plans.size());
        for (_unit = 0; _unit < _plans.size(); ++_unit)
            addUnit(_skeleton.units[_unit], _plans[_unit]);
        return std::move(_skin);
    }

private:
    float last() const { return static_cast<float>(_skeleton.ringsPerBranch - 1); }

    void addUnit(const BranchUnit& branch, const SkinPlan& plan) {
        const auto parent = static_cast<std::size_t>(std::max(branch.parent, 0));
        _bark = barkStart(branch, _skin);
        Frame frame(_skeleton.tangent(_unit, 0));
        if (plan.fromEnd) {
            frame = _ends[parent];
            const std::vector<float> places = evenPlaces(plan.rings);
            copyLastRing(parent, plan.sides);
            const float stem = _skeleton.units[parent].tipRadius;
            for (int i = 1; i < plan.rings; ++i) {
                const float place = places[static_cast<std::size_t>(i)];
                const float left = glm::max(1.0f - lengthTo(place) / (limbLength * stem), 0.0f);
                addRing(frame, place, plan.sides, (stem - branch.baseRadius) * left * left);
            }
        } else if (branch.parent < 0) {
            const std::vector<float> places = stemPlaces(plan);
            // A foot between two rings would become a cone as high as the distance of the rings.
            const bool hasFoot = sectionAt(_skeleton, _unit, places[1]).centre.z < _foot.height();
            for (const float place : places) {
                addRing(frame, place, plan.sides);
                for (int side = 0; hasFoot && side < plan.sides; ++side) {
                    SkinVertex& vertex =
                        _skin.vertices[_skin.vertices.size() - static_cast<std::size_t>(plan.sides - side)];
                    vertex.radius *=
                        _foot.widening(vertex.centre.z, glm::two_pi<float>() * partOf(side, plan.sides));
                }
            }
        } else {
            addSideBranch(frame, plan, parent);
        }
        if (plan.closed)
            addTip(frame);
        _ends.push_back(frame);
        finishUnit(_skin, plan.rings, plan.sides, plan.closed);
    }

    void addSideBranch(Frame& frame, const SkinPlan& plan, std::size_t parent) {
        const BranchUnit& branch = _skeleton.units[_unit];
        const BranchUnit& bearer = _skeleton.units[parent];
        const int sides = _plans[parent].sides;
        const float inside =
            collarDepth * ringWidening(sides) * cosine(glm::pi<float>() / static_cast<float>(sides));
        const BranchCollar collar(_skeleton, _unit,
                                  inside * glm::mix(bearer.baseRadius, bearer.tipRadius, branch.attach));
        const bool isHidden = plan.skeletonRings < 3 || collar.begin() > 0.75f * last();
        const std::vector<float> places = isHidden ? evenPlaces(plan.rings) : sideBranchPlaces(collar, plan);
        const std::size_t first = _skin.vertices.size();
        if (isHidden) {
            addRing(frame, 0.0f, plan.sides);
        } else {
            for (int side = 0; side < plan.sides; ++side) {
                const float part = partOf(side, plan.sides);
                _skin.vertices.push_back(collar.vertex(frame.outward(glm::two_pi<float>() * part)));
                _skin.vertices.back().uv = {2.0f * part, barkAt(collar.begin())};
            }
        }
        for (std::size_t i = first; i < _skin.vertices.size(); ++i)
            _skin.vertices[i].unit = static_cast<float>(parent);
        for (std::size_t i = 1; i < places.size(); ++i) {
            const float wider = isHidden ? 0.0f : collar.widening(places[i]) - 1.0f;
            addRing(frame, places[i], plan.sides, wider * branch.baseRadius);
        }
    }

    std::vector<float> evenPlaces(int rings) const {
        std::vector<float> places;
        for (int i = 0; i < rings; ++i) {
            const int ring = i * (_skeleton.ringsPerBranch - 1) / (rings - 1);
            places.push_back(rings > _skeleton.ringsPerBranch
                                 ? last() * static_cast<float>(i) / static_cast<float>(rings - 1)
                                 : static_cast<float>(ring));
        }
        return places;
    }

    std::vector<float> stemPlaces(const SkinPlan& plan) const {
        std::vector<float> places = evenPlaces(plan.skeletonRings);
        const float rise = glm::max(_skeleton.point(_unit, 1).z - _skeleton.point(_unit, 0).z, 1e-6f);
        if (plan.rings > plan.skeletonRings)
            for (const float share : StemFoot::rings)
                places.push_back(glm::min(share * _foot.height() / rise, last()));
        std::sort(places.begin(), places.end());
        return places;
    }

    /// Rings of a side branch: the collar, those up to its end, and those of the skeleton beyond.
    std::vector<float> sideBranchPlaces(const BranchCollar& collar, const SkinPlan& plan) const {
        std::vector<float> beyond = evenPlaces(plan.skeletonRings);
        beyond.erase(beyond.begin(), std::find_if(beyond.begin(), beyond.end() - 1, [&](float place) {
                         return place > collar.end() + minRingDistance;
                     }));
        if (static_cast<int>(beyond.size()) == plan.rings - 1 && plan.rings > 2)
            beyond.erase(beyond.begin());
        float end = collar.end();
        if (end + minRingDistance >= last()) {
            beyond.clear();
            end = last();
        }
        std::vector<float> places{collar.begin()};
        const auto count = plan.rings - 1 - static_cast<int>(beyond.size());
        for (int i = 1; i <= count; ++i)
            places.push_back(
                glm::mix(collar.begin(), end, static_cast<float>(i) / static_cast<float>(count)));
        places.insert(places.end(), beyond.begin(), beyond.end());
        return places;
    }

    static float partOf(int side, int sides) { return static_cast<float>(side) / static_cast<float>(sides); }

    /// Length of the unit's centre line from its base, metres.
    float lengthTo(float place) const {
        float length = 0.0f;
        for (int ring = 0; static_cast<float>(ring) < place; ++ring)
            length += glm::min(place - static_cast<float>(ring), 1.0f) *
                      glm::distance(_skeleton.point(_unit, ring), _skeleton.point(_unit, ring + 1));
        return length;
    }

    float barkAt(float place) const {
        return _bark +
               lengthTo(place) / (glm::two_pi<float>() * glm::max(_skeleton.units[_unit].baseRadius, 1e-6f));
    }

    /// @param wider than the skeleton by so much, metres.
    void addRing(Frame& frame, float place, int sides, float wider = 0.0f) {
        const CrossSection section = sectionAt(_skeleton, _unit, place);
        frame.follow(section.tangent);
        for (int side = 0; side < sides; ++side) {
            const float part = partOf(side, sides), angle = glm::two_pi<float>() * part;
            SkinVertex vertex;
            vertex.centre = section.centre;
            vertex.radius = (section.radius + wider) * ringWidening(sides);
            vertex.outward = frame.outward(angle);
            vertex.unit = static_cast<float>(_unit);
            vertex.uv = {2.0f * part, barkAt(place)};
            _skin.vertices.push_back(vertex);
        }
    }

    /// Copies the last ring of the parent, or every n-th vertex of it.
    void copyLastRing(std::size_t parent, int sides) {
        const int step = _plans[parent].sides / sides;
        const std::size_t first =
            _skin.firstVertices[parent + 1] - static_cast<std::size_t>(_plans[parent].sides);
        for (int side = 0; side < sides; ++side) {
            _skin.vertices.push_back(_skin.vertices[first + static_cast<std::size_t>(side * step)]);
            _skin.vertices.back().uv = {2.0f * partOf(side, sides), _bark};
        }
    }

    void addTip(const Frame& frame) {
        SkinVertex tip = _skin.vertices.back();
        tip.outward = frame.tangent;
        tip.uv.x = 1.0f;
        _skin.vertices.push_back(tip);
    }

    const Skeleton& _skeleton;
    const std::vector<SkinPlan> _plans;
    const StemFoot _foot;
    std::vector<Frame> _ends; ///< Per unit.
    BranchSkin _skin;
    std::size_t _unit = 0; ///< The current unit.
    float _bark = 0.0f;    ///< Bark coordinate v at its base.
};

} // namespace

BranchSkin makeJoinedSkin(const Skeleton& skeleton, float tolerance) {
    return SkinMaker(skeleton, tolerance).make();
}

} // namespace osgTreeWind
