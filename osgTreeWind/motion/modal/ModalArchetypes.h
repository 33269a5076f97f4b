// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/motion/modal/Archetype.h>

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace osgTreeWind {

/// The archetypes of a forest's trees: one for all near a rung.
class ModalArchetypes {
public:
    /// @param exact gives each tree one of its own, which takes milliseconds and tens of kB a tree.
    explicit ModalArchetypes(bool exact) : _exact(exact) {}

    /// Index of the one that a form has, or is to have: then it is missing until make().
    std::uint32_t indexOf(const SwayingTree& form);
    bool isNew(const SwayingTree& form) const { return _exact || _rungs.count(nearestRung(form)) == 0; }
    std::size_t missing() const { return _missing.size(); }
    /// Makes those that are missing, milliseconds each.
    void make(const Executor& executor);

    std::size_t size() const { return _made.size(); }
    const Archetype& operator[](std::size_t index) const { return *_made[index]; }
    std::size_t bytes() const;

private:
    bool _exact;
    std::map<ArchetypeRung, std::uint32_t> _rungs; ///< To an index.
    std::vector<std::shared_ptr<const Archetype>> _made;
    std::vector<SwayingTree> _missing;
};

} // namespace osgTreeWind
