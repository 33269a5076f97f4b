// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/BranchParameters.h>
#include <osgTreeWind/motion/DampedParameters.h>
#include <osgTreeWind/motion/ForestDescription.h>
#include <osgTreeWind/motion/UnitPose.h>

#include <glm/vec4.hpp>

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

namespace osgTreeWind {

/// A forest in motion, without graphics: the `cpu` way to the pose (design, "The frame").
///
/// All arrays run tree after tree in the order of the description and, within a tree, in access order.
/// Not thread-safe, but for setWind() and wind(), which any thread may call at any time.
class ForestSimulation {
public:
    struct Tree {
        std::size_t model = 0; ///< Index into models().
        std::size_t species = 0;
        TreeScale scale;
        glm::vec3 position{0.0f}; ///< Scene coordinates.
        float heading = 0.0f;
        float leaves = 1.0f;
        std::size_t firstUnit = 0;
        std::size_t firstLeaf = 0;
    };

    /// Grows the shapes and places the trees at rest. Trees of a species that is not there are left out.
    /// @param placed called after each tree, for a person who waits; may be empty.
    explicit ForestSimulation(ForestDescription description, const std::function<void()>& placed = {});

    /// As given, but for trees left out; its wind is the first one, whatever setWind() did.
    const ForestDescription& description() const { return _description; }
    const std::vector<TreeModel>& models() const { return _models; }
    const std::vector<Tree>& trees() const { return _trees; }

    /// The wind from the next advance() on; `damped` goes to it evenly within that step. Null: calm.
    void setWind(WindFieldPtr wind);
    WindFieldPtr wind() const;

    /// Moves on to `time` (seconds): samples the wind at every branch base, takes one step of the law,
    /// flutters the leaves, composes the poses. The first call, and a call with an unchanged or earlier time,
    /// keeps the state (a pause holds), and a time that is not finite is ignored. The laws of the thesis take
    /// one step however much time has passed; for `damped` a jump of more than maxStep counts as maxStep, and
    /// the wind goes evenly from the sample before to this one.
    /// Does not allocate.
    /// @return whether a step was taken.
    bool advance(double time);
    static constexpr double maxStep = 0.1;

    /// The first half of advance(), for a GPU that does the rest: moves on to `time` and samples the wind.
    /// @return seconds to step, or nothing when the state is to be kept.
    std::optional<float> beginStep(double time);
    /// The other half: takes over branch states computed elsewhere, one per unit, and composes the poses.
    void setBranchStates(const glm::vec4* states);
    /// Takes over leaf states computed elsewhere, one per cluster.
    void setLeafStates(const glm::vec4* states);

    /// Back to rest.
    void reset();

    /// Where the wind is sampled: base of each unit at rest, scene coordinates, over ground at the foot of
    /// its tree; for `damped` above or below it, at the height of the centre of the drag on all that the unit
    /// carries.
    const std::vector<WindPlace>& windPlaces() const { return _windPlaces; }
    /// What was sampled last, scene axes, m/s.
    const std::vector<glm::vec3>& windSamples() const { return _windSamples; }
    /// Per unit: (angleXY, angleYZ, wind.x, wind.z), thesis axes of the tree's own frame; for the law
    /// `damped` the angles about both axes of the branch, radians, and their speeds.
    const std::vector<glm::vec4>& branchStates() const { return _branchStates; }
    /// The wind at the start and at the end of the last step in the axes of each tree's own frame, w 0: two
    /// per unit.
    const std::vector<glm::vec4>& windTexels() const { return _windTexels; }
    /// Per unit, what the law of the description works with; the other one is empty.
    const std::vector<BranchParameters>& branchParameters() const { return _branches; }
    const std::vector<DampedParameters>& dampedParameters() const { return _dampedBranches; }

    /// Per leaf cluster: (motionAngleX, motionAngleZ, totalRotaAngle, noise), in the leaf's own frame.
    const std::vector<glm::vec4>& leafStates() const { return _leafStates; }
    /// Per unit: its own turn about its base, in the tree's rest axes.
    const std::vector<glm::quat>& rotations() const { return _rotations; }
    /// Per unit: pose in the tree's frame.
    const std::vector<UnitPose>& poses() const { return _poses; }

private:
    void prepareUnits(const Tree& tree);
    std::size_t endOfUnits(const Tree& tree) const;
    void sampleWind(double time);
    void turnBranches(const Tree& tree, std::uint32_t seed, double time);
    void swingBranches(const Tree& tree, float seconds);
    void flutterLeaves(const Tree& tree, std::uint32_t seed, double time);
    void pose(const Tree& tree);

    ForestDescription _description;
    std::vector<TreeModel> _models;
    std::vector<Tree> _trees;
    std::vector<BranchParameters> _branches;       // per unit, for the laws of the thesis
    std::vector<DampedParameters> _dampedBranches; // per unit, for `damped`
    std::vector<WindPlace> _windPlaces;
    std::vector<glm::vec3> _windSamples;
    std::vector<glm::vec4> _windTexels, _branchStates, _leafStates;
    std::vector<glm::quat> _rotations;
    std::vector<UnitPose> _poses;
    std::optional<double> _time;
    mutable std::mutex _windMutex; // guards _wind
    WindFieldPtr _wind;
};

} // namespace osgTreeWind
