// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/wind/WindField.h>

namespace osgTreeWind {

/// The wind that a forest is given as its trees meet it: continued down among them where the forest's
/// description asks for that (WindCanopy). One thread.
class WindAmongTrees {
public:
    /// @param given null: calm. @return the same object while nothing changes.
    WindFieldPtr from(const WindFieldPtr& given, const PlacedForest& forest);

    /// Trees have come, gone or changed: who shelters whom is worked out anew with the next wind, which takes
    /// some 20 microseconds a tree.
    void treesChanged() { _given.reset(); }

private:
    WindFieldPtr _given, _met;
};

} // namespace osgTreeWind
