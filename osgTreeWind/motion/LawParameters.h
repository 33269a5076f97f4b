// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/BranchParameters.h>
#include <osgTreeWind/motion/DampedParameters.h>
#include <osgTreeWind/motion/Laws.h>
#include <osgTreeWind/motion/Species.h>

namespace osgTreeWind {

// Parameters in the form in which the laws take them. Not for installed headers, as Laws.h.

inline Laws::ThesisBranch lawParameters(const BranchParameters& p) {
    return {p.spring, p.length, p.maxAngle, p.partialSteps, p.levelLoad};
}

inline Laws::DampedBranch lawParameters(const DampedParameters& p) {
    return {p.stiffness, p.inertia, p.damping, p.drag, p.lever, p.maxAngle, p.streamlining, p.streamlinedTo};
}

inline Laws::ThesisLeaf lawParameters(const LeafMotion& m) {
    return {m.maxAngleX, m.maxAngleZ, m.maxRotation, m.partialSteps, m.factor, m.linkedFactor};
}

} // namespace osgTreeWind
