// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/BranchSkin.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/UnitVectors.h>
#include <osgTreeWind/model/StemFoot.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <utility>

namespace osgTreeWind {
namespace {

float partOf(int side, int sides) {
    return static_cast<float>(side) / static_cast<float>(sides);
}

/// Perimeter of a regular polygon over twice its radius; proportional to its mean width.
float perimeter(int sides) {
    return static_cast<float>(sides) * math::sin(glm::pi<float>() / static_cast<float>(sides));
}

/// Factor on the radius of a ring that gives it the mean width of an octagon.
float ringWidening(int sides) {
    return perimeter(BranchSkin::verticesPerRing) / perimeter(sides);
}

/// Length along a branch over which its bark coordinate v rises by 1, metres.
float barkLength(float radius) {
    return glm::two_pi<float>() * glm::clamp(radius, 1e-6f, BranchSkin::thickRadius);
}

/// Bark coordinate v at the base of a unit, continued from its parent. @param skin of all previous units.
float barkStart(const BranchUnit& unit, const BranchSkin& skin) {
    if (unit.parent < 0)
        return 0.0f;
    const auto parent = static_cast<std::size_t>(unit.parent);
    return glm::mix(skin.vertices[skin.firstVertices[parent]].uv.y,
                    skin.vertices[skin.firstVertices[parent + 1] - 1].uv.y, unit.attach);
}

/// Adds the triangles between rings of vertices. @param closed whether one more vertex closes the end.
void addRingTriangles(BranchSkin& skin, std::size_t firstVertex, int rings, int sides, bool closed) {
    const auto around = static_cast<std::uint32_t>(sides);
    auto ring = static_cast<std::uint32_t>(firstVertex);
    for (int i = 1; i < rings; ++i, ring += around)
        for (std::uint32_t side = 0; side < around; ++side) {
            const std::uint32_t a = ring + side, b = ring + (side + 1) % around;
            skin.indices.insert(skin.indices.end(), {a, b, b + around, a, b + around, a + around});
        }
    for (std::uint32_t side = 0; closed && side < around; ++side)
        skin.indices.insert(skin.indices.end(), {ring + side, ring + (side + 1) % around, ring + around});
}

/// Ends a unit: adds its triangles as addRingTriangles() does, for all vertices since the last unit.
void finishUnit(BranchSkin& skin, int rings, int sides, bool closed = false) {
    addRingTriangles(skin, skin.firstVertices.back(), rings, sides, closed);
    skin.endUnit();
}

constexpr float ringTolerance =
    2.0f; ///< Tolerance along a branch over that of its outline: it is less visible.
constexpr float minCollarRadius =
    0.012f; ///< Smallest radius of a branch whose collar has an additional ring, metres.

int fullSides(const Skeleton& skeleton, float radius) {
    if (!skeleton.joined)
        return BranchSkin::verticesPerRing;
    return radius >= 0.2f ? 24 : radius >= 0.12f ? 20 : radius >= 0.05f ? 10 : radius >= 0.02f ? 8 : 6;
}

/// The smallest number of sides whose midpoints are within a tolerance of the circle.
int sidesWithin(float radius, float tolerance, int most) {
    for (const int sides : {3, 4, 6, 8, 12})
        if (sides < most &&
            radius * (1.0f - ringWidening(sides) * math::cos(glm::pi<float>() / static_cast<float>(sides))) <
                tolerance)
            return sides;
    return most;
}

/// Whether a polyline of that many rings approximates a unit within a tolerance.
bool areRingsWithin(const Skeleton& skeleton, std::size_t unit, int rings, float tolerance) {
    const int last = skeleton.ringsPerBranch - 1;
    for (int i = 0; i + 1 < rings; ++i) {
        const int from = i * last / (rings - 1), to = (i + 1) * last / (rings - 1);
        const glm::vec3 start = skeleton.point(unit, from), along = skeleton.point(unit, to) - start;
        for (int ring = from + 1; ring < to; ++ring) {
            const float part = static_cast<float>(ring - from) / static_cast<float>(to - from);
            if (!(glm::distance(skeleton.point(unit, ring), start + part * along) < tolerance))
                return false;
        }
    }
    return true;
}

int ringsWithin(const Skeleton& skeleton, std::size_t unit, float tolerance, int fewest) {
    int rings = glm::min(fewest, skeleton.ringsPerBranch);
    while (rings < skeleton.ringsPerBranch &&
           (tolerance <= 0.0f || !areRingsWithin(skeleton, unit, rings, ringTolerance * tolerance)))
        ++rings;
    return rings;
}

/// Rings and sides of the skin of one unit.
struct SkinPlan {
    int rings = 2, sides = 3;
    int skeletonRings = 2; ///< Rings at points of the skeleton, evenly spaced; without foot and collar.
    bool fromEnd = false;  ///< Whether the unit springs from its parent's end.
    bool closed = false;   ///< Whether a vertex closes the tip.
};

/// Plans the skin of all units, see makeBranchSkin(). The number of sides follows from the thickness of a
/// branch; in a joined skeleton it is halved along an axis as that thins, so that the rings of successive
/// units share corners.
std::vector<SkinPlan> planSkin(const Skeleton& skeleton, float tolerance) {
    std::vector<SkinPlan> plans;
    plans.reserve(skeleton.units.size());
    for (std::size_t i = 0; i < skeleton.units.size(); ++i) {
        const BranchUnit& unit = skeleton.units[i];
        const bool stem = unit.parent < 0;
        SkinPlan plan;
        plan.sides = sidesWithin(unit.baseRadius, tolerance, fullSides(skeleton, unit.baseRadius));
        plan.fromEnd = skeleton.joined && !stem && unit.attach >= 1.0f;
        plan.closed = skeleton.joined && unit.tipRadius >= tolerance;
        const bool hasCollar = skeleton.joined && !stem && !plan.fromEnd &&
                               unit.baseRadius >= glm::max(minCollarRadius, 4.0f * tolerance);
        plan.rings = plan.skeletonRings = ringsWithin(skeleton, i, tolerance, hasCollar ? 3 : 2);
        if (plan.fromEnd) {
            SkinPlan& parent = plans[static_cast<std::size_t>(unit.parent)];
            parent.closed = false;
            int sides = parent.sides;
            while (sides % 2 == 0 && sides / 2 >= plan.sides)
                sides /= 2;
            plan.sides = sides;
        } else if (skeleton.joined && stem && StemFoot(skeleton).height() > 0.0f &&
                   skeleton.flare * unit.baseRadius > tolerance) {
            plan.rings += static_cast<int>(StemFoot::rings.size());
        } else if (hasCollar) {
            ++plan.rings;
        }
        plans.push_back(plan);
    }
    return plans;
}

/// @param start bark coordinate v at the base.
void addRings(const Skeleton& skeleton, std::size_t unit, int rings, int sides, float start,
              std::vector<SkinVertex>& vertices) {
    glm::vec3 e1 = perpendicular(skeleton.tangent(unit, 0));
    const float repeat = barkLength(skeleton.units[unit].baseRadius);
    const float widening = ringWidening(sides);
    float along = 0.0f;
    for (int i = 0, before = 0; i < rings; ++i) {
        const int ring = i * (skeleton.ringsPerBranch - 1) / (rings - 1);
        const glm::vec3 tangent = skeleton.tangent(unit, ring);
        // Parallel transport, so that successive rings are not twisted.
        e1 = directionOr(e1 - tangent * glm::dot(e1, tangent), perpendicular(tangent));
        const glm::vec3 e2 = glm::cross(tangent, e1);
        along += glm::distance(skeleton.point(unit, ring), skeleton.point(unit, before));
        before = ring;
        for (int side = 0; side < sides; ++side) {
            const float part = partOf(side, sides), angle = glm::two_pi<float>() * part;
            SkinVertex vertex;
            vertex.centre = skeleton.point(unit, ring);
            vertex.radius = skeleton.radius(unit, ring) * widening;
            vertex.outward = math::cos(angle) * e1 + math::sin(angle) * e2;
            vertex.unit = static_cast<float>(unit);
            vertex.uv = {2.0f * part, start + along / repeat};
            vertices.push_back(vertex);
        }
    }
}

BranchSkin openTubes(const Skeleton& skeleton, float tolerance) {
    BranchSkin skin;
    const std::vector<SkinPlan> plans = planSkin(skeleton, tolerance);
    for (std::size_t unit = 0; unit < plans.size(); ++unit) {
        const SkinPlan& plan = plans[unit];
        addRings(skeleton, unit, plan.rings, plan.sides, barkStart(skeleton.units[unit], skin),
                 skin.vertices);
        finishUnit(skin, plan.rings, plan.sides);
    }
    return skin;
}

constexpr float collarWidth = 1.6f, collarLength = 2.5f; ///< Over the radius of the branch.
constexpr float steepest = 0.3f; ///< Lower limit of the sine of the angle between branch and parent.

/// The collar of a branch that springs along its parent: a ring on the parent's bark, wider than the branch.
class BranchCollar {
public:
    /// @param bark radius of the parent at the base of the branch, metres.
    BranchCollar(const Skeleton& skeleton, std::size_t unit, float bark)
        : _bark(bark), _parent(skeleton.units[unit].parent) {
        const BranchUnit& branch = skeleton.units[unit];
        const float place = branch.attach * static_cast<float>(skeleton.ringsPerBranch - 1);
        const int ring = glm::min(static_cast<int>(place), skeleton.ringsPerBranch - 2);
        const auto parent = static_cast<std::size_t>(_parent);
        const glm::vec3 heading = skeleton.tangent(unit, 0);
        _base = branch.base;
        _along = directionOr(skeleton.point(parent, ring + 1) - skeleton.point(parent, ring),
                             skeleton.tangent(parent, ring));
        _away = directionOr(heading - _along * glm::dot(heading, _along), perpendicular(_along));
        _across = glm::cross(_along, _away);
        _cosine = glm::dot(heading, _along);
        _sine = glm::max(glm::dot(heading, _away), steepest);
        _reach = collarWidth * branch.baseRadius;
        const float interval =
            glm::max(glm::distance(skeleton.point(unit, 0), skeleton.point(unit, 1)), 1e-6f);
        _begin = _bark / (_sine * interval);
        _end = _begin + collarLength * branch.baseRadius / interval;
    }

    float begin() const { return _begin; } ///< On the parent's bark, in intervals between the unit's points.
    float end() const { return _end; }     ///< Where the branch has its own radius, in the same intervals.
    /// Factor on the radius of a ring at `place`, between begin() and end().
    float widening(float place) const {
        const float left = 1.0f - glm::clamp((place - _begin) / glm::max(_end - _begin, 1e-6f), 0.0f, 1.0f);
        return 1.0f + (collarWidth - 1.0f) * left * left;
    }
    /// A vertex on the parent's bark, which moves with the parent. @param aside unit vector across the
    /// branch.
    SkinVertex vertex(const glm::vec3& aside) const {
        // Intersection of the cylinder of the parent's bark with a parallel to the branch at `_reach`.
        const float beside = glm::clamp(_reach * glm::dot(aside, _across) / _bark, -0.95f, 0.95f);
        const float toward = std::sqrt(1.0f - beside * beside);
        const float from = _reach * glm::dot(aside, _away);
        const float up = _reach * glm::dot(aside, _along) + (_bark * toward - from) * _cosine / _sine;
        SkinVertex vertex;
        vertex.centre = _base + up * _along;
        vertex.radius = _bark;
        vertex.outward = toward * _away + beside * _across;
        vertex.unit = static_cast<float>(_parent);
        return vertex;
    }

private:
    glm::vec3 _base, _along;  ///< Base of the branch; axis of the parent there.
    glm::vec3 _away, _across; ///< Unit vectors perpendicular to that axis: toward the branch, and sideways.
    float _sine, _cosine;     ///< Of the angle between branch and parent.
    float _bark, _reach;      ///< Radius of the parent's bark; radius of the collar.
    float _begin, _end;
    int _parent;
};

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
        return math::cos(angle) * first + math::sin(angle) * glm::cross(tangent, first);
    }
    /// Rotates the frame by the smallest angle to a new tangent, so that successive rings are not twisted.
    void follow(const glm::vec3& next) {
        first -= (tangent + next) * (glm::dot(first, next) / glm::max(1.0f + glm::dot(tangent, next), 1e-3f));
        first = directionOr(first - next * glm::dot(first, next), perpendicular(next));
        tangent = next;
    }
};

/// Makes the bark of a joined skeleton; see makeBranchSkin().
class JoinedSkin {
public:
    JoinedSkin(const Skeleton& skeleton, float tolerance)
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
                if (hasFoot)
                    widenFoot(frame, plan.sides);
            }
        } else {
            addSideBranch(frame, plan, parent);
        }
        if (plan.closed)
            addTip(frame);
        _ends.push_back(frame);
        finishUnit(_skin, plan.rings, plan.sides, plan.closed);
    }

    /// Widens the last ring at the foot of the stem.
    void widenFoot(const Frame& frame, int sides) {
        for (int side = 0; side < sides; ++side) {
            SkinVertex& vertex =
                _skin.vertices[_skin.vertices.size() - static_cast<std::size_t>(sides - side)];
            const float z = vertex.centre.z, angle = glm::two_pi<float>() * partOf(side, sides);
            if (z >= _foot.height())
                return;
            const glm::vec3 normal = _foot.normal(z, angle, vertex.radius);
            vertex.radius *= _foot.widening(z, angle);
            glm::vec3 position = vertex.position();
            if (z <= 0.0f)
                position.z -= _foot.depth();
            vertex.outward = normal.x * vertex.outward +
                             normal.y * glm::cross(frame.tangent, vertex.outward) + normal.z * frame.tangent;
            vertex.centre = position - vertex.radius * vertex.outward;
        }
    }

    void addSideBranch(Frame& frame, const SkinPlan& plan, std::size_t parent) {
        const BranchUnit& branch = _skeleton.units[_unit];
        const BranchUnit& bearer = _skeleton.units[parent];
        const int sides = _plans[parent].sides;
        const float inside =
            collarDepth * ringWidening(sides) * math::cos(glm::pi<float>() / static_cast<float>(sides));
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

    /// Length of the unit's centre line from its base, metres.
    float lengthTo(float place) const {
        float length = 0.0f;
        for (int ring = 0; static_cast<float>(ring) < place; ++ring)
            length += glm::min(place - static_cast<float>(ring), 1.0f) *
                      glm::distance(_skeleton.point(_unit, ring), _skeleton.point(_unit, ring + 1));
        return length;
    }

    float barkAt(float place) const {
        return _bark + lengthTo(place) / barkLength(_skeleton.units[_unit].baseRadius);
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

constexpr int shootSides = 3;

/// The ends of a shoot, and the points needed to approximate its course within a tolerance.
std::vector<glm::vec3> courseWithin(const Skeleton& skeleton, const Shoot& shoot, float tolerance) {
    std::vector<glm::vec3> course{skeleton.shootPoint(shoot, 0)};
    for (std::size_t i = 1; i + 1 < shoot.count; ++i) {
        const glm::vec3 point = skeleton.shootPoint(shoot, i), next = skeleton.shootPoint(shoot, i + 1);
        const glm::vec3 along = directionOr(next - course.back(), up);
        const glm::vec3 from = point - course.back();
        if (!(glm::distance(from, glm::dot(from, along) * along) < tolerance))
            course.push_back(point);
    }
    course.push_back(skeleton.shootPoint(shoot, shoot.count - 1));
    return course;
}

void addPrism(const Shoot& shoot, const std::vector<glm::vec3>& course, BranchSkin& skin) {
    const std::size_t first = skin.vertices.size();
    float length = 0.0f;
    for (std::size_t i = 1; i < course.size(); ++i)
        length += glm::distance(course[i - 1], course[i]);
    const float widening = ringWidening(shootSides);
    const float repeat = barkLength(shoot.baseRadius);
    glm::vec3 tangent = directionOr(course[1] - course[0], up), across = perpendicular(tangent);
    float along = 0.0f;
    SkinVertex vertex;
    vertex.unit = static_cast<float>(shoot.unit);
    for (std::size_t i = 0; i + 1 < course.size(); ++i) {
        tangent = directionOr(course[i + 1] - course[i], tangent);
        across = directionOr(across - tangent * glm::dot(across, tangent), perpendicular(tangent));
        const glm::vec3 beside = glm::cross(tangent, across);
        vertex.centre = course[i];
        vertex.radius =
            widening * glm::mix(shoot.baseRadius, shoot.tipRadius, length > 0.0f ? along / length : 0.0f);
        for (int side = 0; side < shootSides; ++side) {
            const float part = partOf(side, shootSides), angle = glm::two_pi<float>() * part;
            vertex.outward = math::cos(angle) * across + math::sin(angle) * beside;
            vertex.uv = {2.0f * part, along / repeat};
            skin.vertices.push_back(vertex);
        }
        along += glm::distance(course[i], course[i + 1]);
    }
    vertex.centre = course.back();
    vertex.radius = shoot.tipRadius;
    vertex.outward = tangent;
    vertex.uv = {1.0f, along / repeat};
    skin.vertices.push_back(vertex);
    addRingTriangles(skin, first, static_cast<int>(course.size()) - 1, shootSides, true);
}

/// Numbers of what addShootSkin() adds at full detail.
SkinSize sizeOfShootSkin(const Skeleton& skeleton) {
    SkinSize size;
    for (const Shoot& shoot : skeleton.shoots) {
        size.vertices += shootSides * (shoot.count - 1) + 1;
        size.triangles += 2 * shootSides * (shoot.count - 2) + shootSides;
    }
    return size;
}

/// Adds the bark of a skeleton's shoots to that of its units, after the vertices of the unit that bears them:
/// three-sided prisms that close to a point.
/// @param tolerance allowed error of their course, metres. @param thinnest smallest base radius, metres.
void addShootSkin(const Skeleton& skeleton, float tolerance, float thinnest, BranchSkin& skin) {
    if (skeleton.shoots.empty())
        return;
    BranchSkin whole;
    if (tolerance == 0.0f && thinnest == 0.0f) {
        const SkinSize shoots = sizeOfShootSkin(skeleton);
        whole.vertices.reserve(skin.vertices.size() + shoots.vertices);
        whole.indices.reserve(skin.indices.size() + 3 * shoots.triangles);
    }
    auto shoot = skeleton.shoots.begin();
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit) {
        whole.append(skin, unit);
        for (; shoot != skeleton.shoots.end() && shoot->unit == static_cast<int>(unit); ++shoot)
            if (shoot->baseRadius >= thinnest)
                addPrism(*shoot, courseWithin(skeleton, *shoot, tolerance), whole);
        whole.endUnit();
    }
    skin = std::move(whole);
}

} // namespace

void BranchSkin::append(const BranchSkin& other, std::size_t unit) {
    const std::uint32_t before = other.firstVertices[unit];
    const auto now = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), other.vertices.begin() + before,
                    other.vertices.begin() + other.firstVertices[unit + 1]);
    for (std::uint32_t i = other.firstIndices[unit]; i < other.firstIndices[unit + 1]; ++i)
        indices.push_back(other.indices[i] - before + now);
}

void BranchSkin::endUnit() {
    firstVertices.push_back(static_cast<std::uint32_t>(vertices.size()));
    firstIndices.push_back(static_cast<std::uint32_t>(indices.size()));
}

std::vector<SkinVertex> BranchSkin::drawOrder() const {
    std::vector<SkinVertex> ordered;
    ordered.reserve(indices.size());
    for (const std::uint32_t index : indices)
        ordered.push_back(vertices[index]);
    return ordered;
}

BranchSkin makeBranchSkin(const Skeleton& skeleton, float tolerance, float thinnestShoot) {
    BranchSkin skin =
        skeleton.joined ? JoinedSkin(skeleton, tolerance).make() : openTubes(skeleton, tolerance);
    addShootSkin(skeleton, tolerance, thinnestShoot, skin);
    skin.vertices.shrink_to_fit();
    skin.indices.shrink_to_fit();
    return skin;
}

SkinSize sizeOfBranchSkin(const Skeleton& skeleton) {
    SkinSize size = sizeOfShootSkin(skeleton);
    for (const SkinPlan& plan : planSkin(skeleton, 0.0f)) {
        const auto rings = static_cast<std::uint64_t>(plan.rings),
                   sides = static_cast<std::uint64_t>(plan.sides);
        size.vertices += rings * sides + (plan.closed ? 1 : 0);
        size.triangles += 2 * (rings - 1) * sides + (plan.closed ? sides : 0);
    }
    return size;
}

} // namespace osgTreeWind
