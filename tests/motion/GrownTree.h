// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/motion/modal/Archetype.h>
#include <osgTreeWind/motion/modal/JointTree.h>
#include <osgTreeWind/species/GrowthLaws.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/wind/Wind.h>

#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// A tree of a species at a size, and its modal models. Results point into this object.
struct GrownTree {
    Species species;
    TreeModel model;
    TreeScale scale;
    float leaves;

    GrownTree(Species kind, const TreeSize& size, float leafShare = 1.0f)
        : species(std::move(kind)), model(makeTreeModel(growthOf(species, false))),
          scale(fitTree(model, size)), leaves(leafShare) {}
    GrownTree(const std::string& name, const TreeSize& size, float leafShare = 1.0f)
        : GrownTree(*findSpecies(name), size, leafShare) {}

    const std::vector<BranchUnit>& units() const { return model.skeleton.units; }
    TreeForm form() const { return {&model, &species, scale, leaves}; }
    JointTree joints() const { return makeJointTree(model, scale, species, leaves); }
    ModalMaterial material() const {
        return {species.wood.dampingRatio, species.wood.streamlining, species.wood.streamlinedTo,
                species.branch.maxAngle, species.wood.breezeStreamlining};
    }
    /// Index of the trunk's last unit.
    std::size_t top() const {
        std::size_t last = 0;
        for (std::size_t i = 0; i < units().size(); ++i)
            if (units()[i].level == 0)
                last = i;
        return last;
    }
    /// Position in the tree's own frame, metres.
    glm::dvec3 tipOf(std::size_t unit) const { return scale.axes * units()[unit].tip; }
};

/// Whether `carrier` is `link` or one of its ancestors.
inline bool carries(const JointTree& tree, std::size_t carrier, std::size_t link) {
    int i = static_cast<int>(link);
    while (i > static_cast<int>(carrier))
        i = tree.links[static_cast<std::size_t>(i)].parent;
    return i == static_cast<int>(carrier);
}

inline ModalModel makeModalModel(const JointTree& tree, const ModalMaterial& material,
                                 const ModalDetail& detail = {}) {
    return makeModalModels(tree, material, {detail}).front();
}

/// The end of a unit as a point of its link.
inline JointTree::Point tipPoint(const GrownTree& tree, const JointTree& joints, std::size_t unit) {
    JointTree::Point point;
    point.link = unit;
    point.place = tree.tipOf(unit);
    point.lever = point.place - joints.links[unit].base;
    return point;
}

/// A gusty wind along x with this mean speed at all heights and an intensity of 0.25 at 10 m.
inline WindFieldPtr gustsOf(float speed) {
    Wind wind(std::make_shared<UniformWind>(glm::vec3(speed, 0.0f, 0.0f)));
    wind.gusts.intensity = 0.25;
    return asField(wind);
}

} // namespace osgTreeWind
