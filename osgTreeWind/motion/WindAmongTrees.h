// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/CanopyOfTrees.h>
#include <osgTreeWind/wind/WindField.h>

#include <optional>
#include <vector>

namespace osgTreeWind {

/// The wind that a forest is given as its trees meet it: continued down among them where the forest's
/// description asks for that (WindCanopy). One thread.
class WindAmongTrees {
public:
    /// @param given null: calm. @return the same object while nothing changes.
    WindFieldPtr from(const WindFieldPtr& given, const PlacedForest& forest);

    /// The stands that the last wind was continued into; null: none yet, or it was left as given.
    const std::shared_ptr<const CanopyMap>& canopy() const { return _canopy; }

    /// A tree has come, gone or changed: who shelters whom is worked out anew with the next wind.
    void treeChanged(std::size_t slot);
    void allTreesChanged();

private:
    std::shared_ptr<const CanopyMap> canopyOfForest(const PlacedForest& forest);

    std::vector<std::optional<StandTree>> _trees; ///< By slot; none of those that changed.
    std::shared_ptr<const CanopyMap> _canopy;     ///< Null: trees have changed.
    WindFieldPtr _given, _met;
};

} // namespace osgTreeWind
