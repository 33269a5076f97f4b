// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Crs.h>

namespace osgTreeWind {

/// The way of places from one system to another. Used by one thread at a time.
class CrsWay {
public:
    /// Leaves places where they are.
    CrsWay() = default;
    static Result<CrsWay> between(const Crs& from, const Crs& to);

    /// Brings a place there. False, and no place any more, where it has none.
    bool go(glm::dvec2& place) const;

    /// An OGRCoordinateTransformationH; null where places stay.
    void* transformation() const { return _transformation.get(); }

private:
    std::shared_ptr<void> _transformation;
};

/// The UTM zone of a place of some system. @param key that may say another system, for the message where the
/// place is none of this one.
Result<Crs> utmZoneOf(glm::dvec2 place, const Crs& of, const std::string& key);

} // namespace osgTreeWind
