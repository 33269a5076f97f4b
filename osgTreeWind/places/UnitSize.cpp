// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/UnitSize.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/places/MapProgram.h>

namespace osgTreeWind {

Result<double> sizeOfUnit(Dimension dimension, const std::string& name) {
    if (const auto size = knownUnit(dimension, name))
        return *size;
    constexpr std::size_t maxLength = 100;
    if (name.empty() || name.size() > maxLength ||
        (dimension != Dimension::Length && dimension != Dimension::Speed))
        return fileProblem({}, expectedFound(expectedUnit(dimension), name));
    const auto size = MapProgram::shared()->request<double>(
        {MapRequest::Task::SizeOfUnit, {name, dimension == Dimension::Length ? "m" : "m s-1"}});
    if (!size)
        return fileProblem({}, expectedFound(expectedUnit(dimension), name) +
                                   "; other units: " + size.problems().front().message);
    return size.value() > 0.0 ? size : fileProblem({}, expectedFound(expectedUnit(dimension), name));
}

} // namespace osgTreeWind
