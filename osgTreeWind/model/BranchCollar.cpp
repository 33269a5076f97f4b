// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/BranchCollar.h>

#include <osgTreeWind/base/UnitVectors.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

constexpr float collarWidth = 1.6f, collarLength = 2.5f; ///< Over the radius of the branch.
constexpr float steepest = 0.3f; ///< Lower limit of the sine of the angle between branch and parent.

} // namespace

BranchCollar::BranchCollar(const Skeleton& skeleton, std::size_t unit, float bark)
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
    const float interval = glm::max(glm::distance(skeleton.point(unit, 0), skeleton.point(unit, 1)), 1e-6f);
    _begin = _bark / (_sine * interval);
    _end = _begin + collarLength * branch.baseRadius / interval;
}

float BranchCollar::widening(float place) const {
    const float left = 1.0f - glm::clamp((place - _begin) / glm::max(_end - _begin, 1e-6f), 0.0f, 1.0f);
    return 1.0f + (collarWidth - 1.0f) * left * left;
}

SkinVertex BranchCollar::vertex(const glm::vec3& aside) const {
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

} // namespace osgTreeWind
