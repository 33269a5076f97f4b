// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Crs.h>

#include <memory>
#include <vector>

namespace osgTreeWind {

/// The way of places from one system to another. A value; its copies are used by one thread at a time.
class CrsWay {
public:
    /// Leaves places where they are.
    CrsWay() = default;
    static Result<CrsWay> between(const Crs& from, const Crs& to);

    /// Whether it leaves places where they are.
    bool staysHere() const { return !_held; }
    const Crs& from() const { return _from; }
    const Crs& to() const { return _to; }

    /// Brings places there, all at once; one that has no place there becomes NaN.
    void go(std::vector<glm::dvec2>& places) const;
    /// Brings one place there. @return whether it lies there; else it becomes NaN.
    bool go(glm::dvec2& place) const;

    /// What brings them there: in the programs that link GDAL an OGRCoordinateTransformationH, else the
    /// program that is asked.
    void* transformation() const { return _held.get(); }

private:
    Crs _from, _to;
    std::shared_ptr<void> _held; ///< Null where places stay.
};

/// The UTM zone of a place of some system. @param key that may say another system, for the message where the
/// place is none of this one.
Result<Crs> utmZoneOf(glm::dvec2 place, const Crs& of, const std::string& key);

} // namespace osgTreeWind
