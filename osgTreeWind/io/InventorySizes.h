// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/InventoryColumns.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Reads the sizes of the trees of an inventory, and counts those that cannot be used. Cities write 0 or a
/// mark such as -99 or 999 where nobody measured, and mistype now and then: such a size counts as not given.
class InventorySizes {
public:
    std::vector<double> missing; ///< Further numbers that mean "not measured", in the unit of their column.

    /// Metres; 0 where the row does not give this size.
    float of(const TreeRows& row, const Measure& measure);

    /// The same of the width of an outline, metres.
    float ofOutline(const TreeRows& row, const Measure& measure, double width);

    /// Columns most of whose sizes cannot be used, as where their unit is another one.
    Diagnostics problems() const;
    /// How many sizes count as not given, and the first of them that no tree has.
    std::vector<std::string> notes() const;

private:
    struct Column {
        std::size_t used = 0, marked = 0, impossible = 0;
        Diagnostic first; ///< Of those that are impossible.
    };
    bool isMark(double number) const;

    std::map<std::string, Column> _columns; ///< By keys.
};

} // namespace osgTreeWind
