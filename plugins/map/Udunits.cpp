// SPDX-License-Identifier: MIT
#include <plugins/map/Udunits.h>

#include <osgTreeWind/base/Text.h>

#include <udunits2.h>

#include <cmath>
#include <memory>

namespace osgTreeWind {

namespace {

using UnitPtr = std::unique_ptr<ut_unit, decltype(&ut_free)>;
using Converter = std::unique_ptr<cv_converter, decltype(&cv_free)>;

ut_system* unitSystem() {
    static ut_system* const units = [] {
        ut_set_error_message_handler(ut_ignore);
        return ut_read_xml(nullptr);
    }();
    return units;
}

UnitPtr parse(const std::string& text) {
    return {unitSystem() ? ut_parse(unitSystem(), std::string(trimmed(text)).c_str(), UT_UTF8) : nullptr,
            ut_free};
}

} // namespace

double sizeByUdunits(const std::string& name, const std::string& base) {
    const UnitPtr unit = parse(name), metre = parse(base);
    if (!unit || !metre)
        return 0.0;
    const Converter converter(ut_get_converter(unit.get(), metre.get()), cv_free);
    if (!converter)
        return 0.0;
    // UDUNITS converts reciprocals, s/m to m/s, too.
    const double size = cv_convert_double(converter.get(), 1.0),
                 twice = cv_convert_double(converter.get(), 2.0);
    return std::isfinite(size) && size > 0.0 && std::abs(twice / size - 2.0) < 1e-12 ? size : 0.0;
}

} // namespace osgTreeWind
