// SPDX-License-Identifier: MIT
#include <osgTreeWind/species/SizeLaws.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/base/TextHash.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <algorithm>

namespace osgTreeWind {

namespace {

constexpr double proportionalDiameter = 0.05; // the crown is proportional to diameters below it, metres
constexpr double minSize = 0.001, diameterLimit = 20.0;        // metres
constexpr float heightLimit = 116.0f, crownWidthLimit = 50.0f; // metres

float clampSize(double size, double low, double high) {
    return static_cast<float>(std::min(std::max(size, low), high));
}

/// A log-normal distribution of diameters.
struct LogDiameter {
    double median, spread; // metres, standard deviation of ln(diameter)

    /// Narrows it to the trees of a measured size (Bayes' theorem). @param ratio size / that of the median.
    /// @param power of the diameter in the size. @param deviation of ln(size).
    void narrow(double ratio, double power, double deviation) {
        const double ofLaw = power * spread, total = math::hypot(ofLaw, deviation);
        if (!(total > 0.0))
            return;
        median *= math::pow(ratio, ofLaw * spread / (total * total));
        spread *= deviation / total;
    }
};

class Estimator {
public:
    Estimator(const TreeSize& given, const Species& species, bool openGrown, const std::string& id)
        : _id(id), _species(species), _openGrown(openGrown),
          _scale(openGrown ? species.height.openScale : species.height.scale),
          _power(openGrown ? species.height.openPower : species.height.power),
          _spread(openGrown ? species.height.openSpread : species.height.spread), _tree{given, {}, 0.0} {}

    SizeEstimate estimate() {
        TreeSize& size = _tree.size;
        const bool hasCrown = size.crownWidth > 0.0f;
        if (_scale > 0.0) {
            if (!(size.height > 0.0f) && !(size.trunkDiameter > 0.0f) && hasCrown)
                setDiameterFromCrown();
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
        return math::exp(spread * residual(_id, quantity));
    }
    double crownBase() const { return _openGrown ? _species.crown.openBase : _species.crown.base; }
    double crownSlope() const {
        return _openGrown ? _species.crown.openPerDiameter : _species.crown.perDiameter;
    }
    double crownSpread() const { return _openGrown ? _species.crown.openSpread : _species.crown.spread; }
    double crownFactor() const { return factor(crownSpread(), "crown_width"); }

    double maxHeight() const { return limitToRecord(heightLimit, _species.height.largest); }

    void setHeight() {
        const double diameter = _tree.size.trunkDiameter;
        const double height = _scale * math::pow(lawDiameter(diameter), _power) * factor(_spread, "height");
        const double limit = std::min<double>(maxSlenderness * diameter, maxHeight());
        _tree.size.height = clampSize(height, std::min(minSlenderness * lawDiameter(diameter), limit), limit);
        _tree.estimated.height = true;
    }
    /// Draws a diameter from those of the trees with this height, and with this crown if it is known.
    void setDiameter() {
        const HeightAllometry& law = _species.height;
        const double height = _tree.size.height, width = _tree.size.crownWidth;
        const double least = height / maxSlenderness, most = std::min(height / minSlenderness, diameterLimit);
        LogDiameter diameter{_openGrown ? law.openDiameter : law.diameter,
                             _openGrown ? law.openDiameterSpread : law.diameterSpread};
        diameter.narrow(height / (_scale * math::pow(diameter.median, _power)), _power, _spread);
        diameter.median = std::clamp(diameter.median, least, most);
        if (width > 0.0 && crownSlope() > 0.0) {
            const double usual = crownBase() + crownSlope() * diameter.median;
            diameter.narrow(width / usual, crownSlope() * diameter.median / usual, crownSpread());
        }
        _tree.size.trunkDiameter =
            clampSize(diameter.median * factor(diameter.spread, "trunk_diameter"), least, most);
        _tree.estimated.trunkDiameter = true;
        _tree.diameterSpread = diameter.spread;
    }
    void setDiameterFromCrown() {
        const double base = crownBase(), perDiameter = crownSlope();
        const double width = _tree.size.crownWidth / crownFactor();
        if (!(perDiameter > 0.0))
            return;
        const double diameter =
            std::max((width - base) / perDiameter, width / (perDiameter + base / proportionalDiameter));
        _tree.diameterSpread = crownSpread() * (1.0 + base / (perDiameter * diameter));
        _tree.size.trunkDiameter = clampSize(diameter, minSize, diameterLimit);
        _tree.estimated.trunkDiameter = true;
    }
    void setTypicalHeight() {
        const double usual = usualHeight(_species);
        if (!(usual > 0.0))
            return;
        const double height = usual * factor(_spread, "height");
        _tree.size.height = clampSize(height, minSize, maxHeight());
        _tree.estimated.height = true;
    }
    void setCrown() {
        TreeSize size = _tree.size;
        size.trunkDiameter = static_cast<float>(lawDiameter(size.trunkDiameter));
        const double width = withCrown(size, _species.crown, _openGrown).crownWidth;
        if (!(width > 0.0))
            return;
        _tree.size.crownWidth =
            clampSize(width * crownFactor(), minSize, limitToRecord(crownWidthLimit, _species.crown.largest));
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
        if (random.uniformDouble() < math::exp(-0.5 * z * z / (widened * widened)))
            return z;
    }
}

} // namespace osgTreeWind
