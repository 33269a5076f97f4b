// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/MakeCanopy.h>
#include <osgTreeWind/wind/HostWind.h>
#include <osgTreeWind/wind/WindSampler.h>

#include <optional>
#include <vector>

namespace osgTreeWind {

/// The wind at the trees of a forest, extended into the canopy if Wind::canopy is set. Not thread-safe.
class CanopyWind {
public:
    /// @param time seconds. @return null: calm; the same object as long as nothing changes.
    WindFieldPtr update(HostWind& host, const PlacedForest& forest, double time);

    /// The flow in which the trees' surroundings are defined; null before the first canopy wind. Replaced
    /// when trees have changed, or when the mean wind has changed by a tenth.
    const std::shared_ptr<const CanopyFlow>& flow() const { return _flow; }

    /// A tree was added, removed or changed. The canopy is rebuilt at the next wind or, in a tiled forest, no
    /// sooner than `rebuildInterval` after the last rebuild. The scale of gusts is kept.
    void treeChanged(std::size_t slot);
    static constexpr double rebuildInterval = 5.0; ///< Seconds.
    void allTreesChanged();
    void reset(); ///< Back to the state after construction.

private:
    std::shared_ptr<CanopyMap> buildCanopy(const PlacedForest& forest);

    WindCanopy _settings;                          ///< As requested by the wind.
    std::vector<std::optional<CanopyTree>> _trees; ///< By slot; empty if the tree has changed.
    std::shared_ptr<const CanopyMap> _canopy;      ///< Null before the first canopy wind.
    bool _changed = true;                          ///< Whether trees have changed since `_canopy` was built.
    double _rebuildTime = 0.0;                     ///< Time of the last rebuild, seconds.
    CanopyCell _meanStand; ///< Mean stand of the first canopy that has trees; kept so that gusts do not jump.
    std::shared_ptr<const Wind> _wind; ///< Source of `_sampler`.
    glm::dmat4 _forestToScene{1.0};    ///< HostWind::forestToScene() for `_sampler`.
    std::shared_ptr<const WindSampler> _sampler;
    std::shared_ptr<const CanopyFlow> _flow;
};

} // namespace osgTreeWind
