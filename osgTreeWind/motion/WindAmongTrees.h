// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/CanopyOfTrees.h>
#include <osgTreeWind/wind/GivenWind.h>
#include <osgTreeWind/wind/WindSampler.h>

#include <optional>
#include <vector>

namespace osgTreeWind {

/// The wind that a forest is given as its trees meet it: continued down among them where the wind asks for
/// that (Wind::canopy). One thread.
class WindAmongTrees {
public:
    /// @param time seconds. @return null: calm; the same object while nothing changes.
    WindFieldPtr from(GivenWind& given, const PlacedForest& forest, double time);

    /// In which trees have the company that they have now; null: none yet. Another one when they have
    /// changed, or the mean wind has by a tenth.
    const std::shared_ptr<const CanopyFlow>& company() const { return _company; }

    /// A tree has come, gone or changed: who shelters whom is worked out anew with the next wind, or where
    /// trees come and go by tiles, `patience` after the last time. Gusts stay what they are.
    void treeChanged(std::size_t slot);
    static constexpr double patience = 5.0; ///< Seconds.
    void allTreesChanged();
    /// As if nothing had been.
    void reset();

private:
    std::shared_ptr<CanopyMap> canopyOfForest(const PlacedForest& forest);

    WindCanopy _asked;                             ///< What the wind asks for.
    std::vector<std::optional<CanopyTree>> _trees; ///< By slot; empty if the tree has changed.
    std::shared_ptr<const CanopyMap> _canopy;      ///< Null: none yet.
    bool _changed = true;                          ///< Trees have, since it was made.
    double _madeAt = 0.0;                          ///< Seconds.
    CanopyCell _usual;                             ///< Of the first one with trees: else gusts would jump.
    std::shared_ptr<const Wind> _given;            ///< What `_met` was made of,
    glm::dmat4 _place{1.0};                        ///< where,
    std::shared_ptr<const WindSampler> _met;
    std::shared_ptr<const CanopyFlow> _company;
};

} // namespace osgTreeWind
