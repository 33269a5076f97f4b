// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Range.h>

#include <osgTreeWind/base/Number.h>

namespace osgTreeWind {

std::string Range::text() const {
    const Range all;
    if (max == all.max)
        return min == all.min ? "" : (aboveMin ? "above " : "at least ") + numberText(min);
    if (min == all.min)
        return "at most " + numberText(max);
    return std::string("in ") + (aboveMin ? '(' : '[') + numberText(min) + ", " + numberText(max) + ']';
}

} // namespace osgTreeWind
