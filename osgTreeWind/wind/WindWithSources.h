// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/wind/WindField.h>
#include <osgTreeWind/wind/WindSource.h>

#include <vector>

namespace osgTreeWind {

class SourceFlow;

/// A wind, and what moves the air beside it: shelters take their share of it, all others are added; it bends
/// a rotor's column and carries a vehicle's wake off. A wind that is continued into the trees (WindCanopy) is
/// so before they are. To place, move or take away sources while a forest runs, hand it another one of these:
/// any thread, any time.
class OSGTREEWIND_EXPORT WindWithSources final : public WindField {
public:
    /// @param wind null: calm. Of one with sources it takes the wind within, and theirs with these.
    /// @param sources what is out of range is held within it.
    WindWithSources(WindFieldPtr wind, std::vector<WindSource> sources);
    ~WindWithSources() override;

    glm::vec3 velocity(const WindPlace& place, double time) const override;
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;
    WindFieldPtr withoutGusts() const override;

    const WindFieldPtr& wind() const { return _wind; }                  ///< Null: calm.
    const std::vector<WindSource>& sources() const { return _sources; } ///< As given.

private:
    WindFieldPtr _wind, _mean; ///< The latter without gusts.
    std::vector<WindSource> _sources;
    std::vector<SourceFlow> _flows;
};

} // namespace osgTreeWind
