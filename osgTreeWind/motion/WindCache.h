// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/MakeCanopyMap.h>
#include <osgTreeWind/wind/LayeredWind.h>

#include <glm/mat4x4.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace osgTreeWind {

/// The wind of the host in the coordinates of a forest, without and with the effect of its trees. Rebuilt
/// when the wind, the place of the forest, the canopy settings or the trees change. Not thread-safe.
class WindCache {
public:
    explicit WindCache(const CanopySettings& canopy) : _settings(canopy) {}

    const CanopySettings& canopy() const { return _settings; }
    void setCanopy(const CanopySettings& canopy);
    /// Sets the transform from the forest's coordinates to the scene.
    void setForestToScene(const glm::dmat4& forestToScene);

    /// The wind not changed by the trees. @param wind not null. @return null: calm; the same object as long
    /// as nothing changes.
    WindFieldPtr openField(const std::shared_ptr<const Wind>& wind);
    /// The wind at the trees. @param wind not null. @param time seconds. @return as openField().
    WindFieldPtr fieldAtTrees(const std::shared_ptr<const Wind>& wind, const PlacedForest& forest,
                              double time);
    /// The flow in which the trees' surroundings are defined; null if trees do not change the wind. Replaced
    /// when trees have changed, or when the mean wind has changed by a tenth.
    const std::shared_ptr<const CanopyFlow>& flow() const { return _flow; }

    /// A tree was added, removed or changed. The canopy is rebuilt at the next wind or, in a tiled forest, no
    /// sooner than `rebuildInterval` after the last rebuild. The scale of gusts is kept.
    void treeChanged(std::size_t slot);
    static constexpr double rebuildInterval = 5.0; ///< Seconds.
    void allTreesChanged();
    void reset(); ///< Forgets the trees and the scale of gusts.

private:
    void rebuildMap(const PlacedForest& forest);

    CanopySettings _settings;
    glm::dmat4 _forestToScene{1.0};
    std::shared_ptr<const Wind> _openWind, _treesWind; ///< Sources of `_open` and `_atTrees`; null: outdated.
    WindFieldPtr _open, _atTrees;
    std::shared_ptr<const CanopyFlow> _flow;
    std::vector<std::optional<CanopyTree>> _trees; ///< By slot; empty if the tree has changed.
    std::shared_ptr<const CanopyMap> _map;         ///< Null before the first wind among trees.
    bool _changed = true;                          ///< Whether trees have changed since `_map` was built.
    double _rebuildTime = 0.0;                     ///< Time of the last rebuild, seconds.
    CanopyCell _meanStand; ///< Mean stand of the first canopy that has trees; kept so that gusts do not jump.
    float _extent = 0.0f;  ///< CanopyMap::extent of that canopy.
};

} // namespace osgTreeWind
