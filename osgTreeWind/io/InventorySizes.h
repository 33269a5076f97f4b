// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/InventoryColumns.h>

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace osgTreeWind {

/// Reads tree sizes from an inventory. Markers for missing values, such as 0, -99 or 999, and impossible
/// sizes count as not given. It counts both for notes and problems.
class InventorySizes {
public:
    std::vector<double> missing; ///< Further numbers that mean "not measured", in the unit of the column.

    /// A size in metres; 0 if the row does not give it.
    /// @param record largest size of the species, of which at most 1.5 times is possible; 0 if unknown.
    float read(const TreeRows& row, const MeasureColumn& measure, float record = 0.0f);

    /// Checks a size that the geometry gives, in metres. @param what for messages: "an outline".
    /// @return 0 if no tree has such a size.
    float readGeometry(const TreeRows& row, const MeasureColumn& measure, const char* what, double metres,
                       float record);

    /// A problem for each column in which most sizes are impossible, for example because of a wrong unit.
    Diagnostics problems() const;
    /// Notes on the number of sizes that count as not given, with the first impossible one.
    std::vector<std::string> notes() const;

private:
    struct Column {
        std::size_t used = 0, marked = 0, impossible = 0;
        Diagnostic first; ///< The first impossible size.
    };
    bool isMissingMark(double number) const;
    /// The size, or 0 and a count if it is impossible.
    float checked(const MeasureColumn& measure, const Result<double>& metres);

    std::map<std::string_view, Column> _columns; ///< By key.
};

} // namespace osgTreeWind
