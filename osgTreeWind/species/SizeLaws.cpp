// SPDX-License-Identifier: MIT
#include <osgTreeWind/species/SizeLaws.h>

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/base/TextHash.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr double thin = 0.05; // below this crown and diameter are in proportion
constexpr double least = 0.001, highest = 116.0, thickest = 20.0, widest = 50.0; // metres

/// The diameter that counts in a law: laws were fitted to trees of 1 m at most, and trees that are thicker
/// are hardly higher and little wider. Beyond 1 m it grows ever less, to 2 m.
double fitted(double diameter) {
    return diameter <= 1.0 ? diameter : 2.0 - std::exp(1.0 - diameter);
}

float within(double size, double low, double high) {
    return static_cast<float>(std::min(std::max(size, low), high));
}

class Estimator {
public:
    Estimator(const TreeSize& given, const Species& species, bool openGrown, const std::string& id)
        : _id(id), _species(species), _openGrown(openGrown),
          _scale(openGrown ? species.height.openScale : species.height.scale),
          _power(openGrown ? species.height.openPower : species.height.power),
          _spread(openGrown ? species.height.openSpread : species.height.spread), _tree{given, {}} {}

    SizeEstimate estimate() {
        TreeSize& size = _tree.size;
        const bool hasCrown = size.crownWidth > 0.0f;
        if (_scale > 0.0) {
            if (!(size.height > 0.0f) && !(size.trunkDiameter > 0.0f) && hasCrown)
                setDiameterOfCrown();
            if (size.trunkDiameter > 0.0f && !(size.height > 0.0f))
                setHeight();
            else if (size.height > 0.0f && !(size.trunkDiameter > 0.0f))
                setDiameter();
            else if (!(size.height > 0.0f) && !hasCrown)
                setTypicalHeight();
        }
        if (!hasCrown && size.trunkDiameter > 0.0f)
            setCrown();
        return _tree;
    }

private:
    double factor(double spread, const char* quantity) const {
        return std::exp(spread * residual(_id, quantity));
    }
    double crownFactor() const {
        return factor(_openGrown ? _species.crown.openSpread : _species.crown.spread, "crown_width");
    }

    void setHeight() {
        const double diameter = _tree.size.trunkDiameter;
        const double height = _scale * std::pow(fitted(diameter), _power) * factor(_spread, "height");
        const double limit = std::min(slenderestEstimate * diameter, highest);
        _tree.size.height = within(height, std::min(stoutestEstimate * fitted(diameter), limit), limit);
        _tree.estimated.height = true;
    }
    /// That of which a tree that is off the law as this one has the height.
    void setDiameter() {
        const double height = _tree.size.height;
        const double diameter = std::pow(height / (_scale * factor(_spread, "trunk_diameter")), 1.0 / _power);
        const double limit = std::min(height / stoutestEstimate, thickest);
        _tree.size.trunkDiameter = within(diameter, height / slenderestEstimate, limit);
        _tree.estimated.trunkDiameter = true;
    }
    void setDiameterOfCrown() {
        const CrownAllometry& law = _species.crown;
        const double base = _openGrown ? law.openBase : law.base;
        const double perDiameter = _openGrown ? law.openPerDiameter : law.perDiameter;
        const double width = _tree.size.crownWidth / crownFactor();
        if (!(perDiameter > 0.0))
            return;
        const double diameter = std::max((width - base) / perDiameter, width / (perDiameter + base / thin));
        _tree.size.trunkDiameter = within(diameter, least, thickest);
        _tree.estimated.trunkDiameter = true;
    }
    void setTypicalHeight() {
        const double usual = usualHeight(_species);
        if (!(usual > 0.0))
            return;
        const double height = usual * factor(_spread, "height");
        _tree.size.height = within(height, least, highest);
        _tree.estimated.height = true;
    }
    void setCrown() {
        TreeSize size = _tree.size;
        size.trunkDiameter = static_cast<float>(fitted(size.trunkDiameter));
        const double width = withCrown(size, _species.crown, _openGrown).crownWidth;
        if (!(width > 0.0))
            return;
        _tree.size.crownWidth = within(width * crownFactor(), least, widest);
        _tree.estimated.crownWidth = true;
    }

    const std::string& _id;
    const Species& _species;
    const bool _openGrown;
    const double _scale, _power, _spread;
    SizeEstimate _tree;
};

} // namespace

SizeEstimate estimateSize(const TreeSize& given, const Species& species, bool openGrown,
                          const std::string& id) {
    return Estimator(given, species, openGrown, id).estimate();
}

double residual(const std::string& id, const std::string& quantity) {
    constexpr double widened = 1.3779021241184815; // with this, cut at 2, it has a standard deviation of 1
    Random random(hashOf(quantity + ' ' + id));
    for (;;) {
        const double z = 4.0 * random.uniformDouble() - 2.0;
        if (random.uniformDouble() < std::exp(-0.5 * z * z / (widened * widened)))
            return z;
    }
}

} // namespace osgTreeWind
