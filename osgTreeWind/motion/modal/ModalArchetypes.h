// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/motion/modal/Archetype.h>

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace osgTreeWind {

/// The archetypes of a forest: one per size class.
class ModalArchetypes {
public:
    /// @param exact gives each tree an archetype of its own, for milliseconds and tens of kB per tree.
    explicit ModalArchetypes(bool exact) : _exact(exact) {}

    /// Index of the archetype of a tree. A new archetype is missing until makeMissing().
    std::uint32_t indexOf(const TreeForm& form);
    bool isNew(const TreeForm& form) const { return _exact || _indices.count(sizeClassOf(form)) == 0; }
    std::size_t missingCount() const { return _missing.size(); }
    /// Makes the missing archetypes, in milliseconds each.
    void makeMissing(const Executor& executor);

    std::size_t size() const { return _archetypes.size(); }
    const Archetype& operator[](std::size_t index) const { return *_archetypes[index]; }
    std::size_t bytes() const;

private:
    bool _exact;
    std::map<TreeSizeClass, std::uint32_t> _indices; ///< Index by size class.
    std::vector<std::shared_ptr<const Archetype>> _archetypes;
    std::vector<TreeForm> _missing;
};

} // namespace osgTreeWind
