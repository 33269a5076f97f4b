// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/motion/Archetype.h>
#include <osgTreeWind/wind/WindField.h>

#include <glm/vec2.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace osgTreeWind {

/// The law `modal` for a forest: every tree a short vector, stepped eight at a time with those of its
/// archetype.
///
/// A tree takes stateBytes() beside its archetype. What comes out does not depend on threads or on the
/// processor's instruction set, nor, for near trees, on the other trees; far ones step in turns with those
/// they are kept with. Not thread-safe, but for the threads of its executor.
class ModalMotion {
public:
    /// A tree and where it stands.
    struct Tree {
        SwayingTree form;
        glm::vec3 foot{0.0f}; ///< Scene coordinates, metres.
        float heading = 0.0f; ///< Radians, counter-clockwise from above.
    };
    /// How closely a tree is followed.
    enum class Level : std::uint8_t {
        Near, ///< Up to 12 modes, 10 patches, every step.
        Far   ///< Up to 4 modes, 4 patches, one step in eight over the time of all of them.
    };
    static constexpr unsigned farInterval = 8;

    /// @param gain [0, 100], on the answer to the wind. @param exact gives each tree an archetype of its own
    /// instead of that of the nearest rung, which takes milliseconds and tens of kB a tree.
    ModalMotion(const std::vector<Tree>& trees, float gain, Executor executor, bool exact = false);
    ~ModalMotion();

    std::size_t treeCount() const { return _slots.size(); }
    std::size_t archetypeCount() const { return _archetypes.size(); }
    const Archetype& archetype(std::size_t tree) const;
    /// Sizes of this tree over its archetype's.
    TreeFactors factors(std::size_t tree) const;

    /// From the next step on. What modes and patches have in common is kept.
    void setLevel(std::size_t tree, Level level);
    Level level(std::size_t tree) const;

    /// Takes the wind of this time as that of now, without moving. @param wind null: calm.
    void meet(const WindField* wind, double time);
    /// Moves on by `seconds` > 0 to `time`; the wind goes evenly to what it is then.
    void step(const WindField* wind, double time, float seconds);
    /// Back to rest, in a calm.
    void reset();

    /// Angles of each unit about its two axes as the tree stands (those of `damped`), held within the
    /// species' largest. @param angles one per unit.
    void angles(std::size_t tree, glm::vec2* angles) const;

    /// Per unit: the wind that its patch met last, m/s, scene axes.
    void winds(std::size_t tree, glm::vec3* winds) const;

    /// Amplitudes of the modes, in the order of the archetype's, at most as many as it has; speeds become 0.
    void setAmplitudes(std::size_t tree, const std::vector<float>& amplitudes);
    std::vector<float> amplitudes(std::size_t tree) const;

    /// All bytes kept for the state of trees, and for archetypes.
    std::size_t stateBytes() const;
    std::size_t archetypeBytes() const;

private:
    struct Group;
    struct Slot {
        std::uint32_t group = 0, index = 0;
    };
    struct Place {
        glm::vec3 foot;
        float width; ///< Lengths across over its archetype's.
    };

    float& number(std::size_t tree, std::size_t index);
    float number(std::size_t tree, std::size_t index) const;
    void put(std::size_t tree, std::uint32_t group);
    void take(std::size_t tree);
    struct Work {
        std::uint32_t group, block;
        float seconds;
    };
    void advance(const WindField* wind, double time);
    void addPlaces(const Work& work, std::vector<WindPlace>& places) const;
    void poseVector(std::size_t tree, float* vector) const;

    Executor _executor;
    float _gain;
    InstructionSet _instructions = bestInstructionSet();
    std::vector<std::unique_ptr<const Archetype>> _archetypes;
    std::vector<Group> _groups; ///< Two for each archetype, one a level.
    std::vector<Slot> _slots;   ///< Per tree.
    std::vector<Place> _places; ///< Per tree.
    std::vector<Work> _work;    ///< Of the step at hand.
    unsigned _turn = 0;
};

} // namespace osgTreeWind
