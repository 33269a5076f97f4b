// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalPoses.h>

#include <osgTreeWind/motion/laws/Reconfiguration.h>
#include <osgTreeWind/motion/laws/Rotations.h>
#include <osgTreeWind/motion/laws/StatelessFlutter.h>
#include <osgTreeWind/motion/laws/UnitPose.h>

namespace osgTreeWind {

std::vector<UnitPose> modalPoses(const PlacedForest& forest, std::size_t slot, const ModalMotion& modal,
                                 const ModalMotion::PoseVector& vector) {
    const PlacedTree& tree = forest.trees[slot];
    const Skeleton& skeleton = forest.modelOf(tree).skeleton;
    std::vector<glm::quat> rotations;
    for (std::size_t i = 0; i < skeleton.units.size(); ++i)
        rotations.push_back(swungRotation(skeleton.units[i], tree.scale, modal.unitAngles(slot, i, vector)));
    std::vector<UnitPose> poses(rotations.size());
    composePoses(skeleton, tree.scale, rotations.data(), poses.data());
    return poses;
}

TreeMotion ModalPoses::motion(std::size_t slot, UnitValues& values) const {
    if (!modal.holds(slot))
        return {};
    const PlacedTree& tree = forest.trees[slot];
    const Skeleton& skeleton = forest.modelOf(tree).skeleton;
    const std::size_t units = skeleton.units.size();
    values.resize(units, withLeaves ? forest.leafCount(tree) : 0);
    modal.angles(slot, values.angles.data());
    modal.winds(slot, values.winds.data());
    const TreeFall* fall = modal.fall(slot);
    for (std::size_t i = 0; i < units; ++i) {
        values.states[i] = glm::vec4(values.angles[i], 0.0f, 0.0f);
        const glm::quat swung = swungRotation(skeleton.units[i], tree.scale, values.angles[i]);
        values.rotations[i] = fall ? fall->turned(i, swung) : swung;
    }
    composePoses(skeleton, tree.scale, values.rotations.data(), values.poses.data());
    if (withLeaves) {
        pull(slot, values);
        flutter(tree, values);
    }
    return {{values.poses.data(), units},
            {values.rotations.data(), units},
            {values.states.data(), units},
            {values.winds.data(), units},
            {values.leaves.data(), values.leaves.size()},
            {values.pulls.data(), withLeaves ? units : 0}};
}

UnitMotion ModalPoses::unitMotion(std::size_t slot, std::size_t unit) const {
    const PlacedTree& tree = forest.trees[slot];
    const std::vector<BranchUnit>& units = forest.modelOf(tree).skeleton.units;
    const ModalMotion::PoseVector vector = modal.poseVector(slot);
    const TreeFall* fall = modal.fall(slot);
    const auto motionOf = [&](const auto& self, std::size_t at) -> UnitMotion {
        const int parent = units[at].parent;
        const UnitPose carrier = parent < 0 ? UnitPose() : self(self, static_cast<std::size_t>(parent)).pose;
        glm::quat rotation = swungRotation(units[at], tree.scale, modal.unitAngles(slot, at, vector));
        if (fall)
            rotation = fall->turned(at, rotation);
        return {childPose(carrier, rotation, tree.scale.axes * units[at].base), rotation};
    };
    return motionOf(motionOf, unit);
}

void ModalPoses::pull(std::size_t slot, UnitValues& values) const {
    const Reconfiguration foliage(forest.speciesOf(forest.trees[slot]));
    glm::vec3 winds[ModalDetail::maxPatches];
    modal.patchWinds(slot, winds);
    const std::vector<std::size_t>& patches = modal.model(slot).patchOfLink;
    for (std::size_t unit = 0; unit < patches.size(); ++unit) {
        const glm::vec4 pull = foliage.pull(winds[patches[unit]]);
        values.pulls[unit] = glm::vec4(glm::conjugate(values.poses[unit].rotation) * glm::vec3(pull), pull.w);
    }
}

void ModalPoses::flutter(const PlacedTree& tree, UnitValues& values) const {
    const std::vector<LeafCluster>& leaves = forest.modelOf(tree).leaves;
    const LeafMotion& leaf = forest.speciesOf(tree).leaf;
    StatelessFlutter{{leaves.data(), leaves.size()},
                     tree.scale.axes,
                     {values.winds.data(), values.winds.size()},
                     {values.pulls.data(), values.pulls.size()},
                     flutterPhases(time, leaf),
                     flutterLimits(leaf),
                     treeRandom(tree.seed)}
        .run(values.leaves.data());
}

} // namespace osgTreeWind
