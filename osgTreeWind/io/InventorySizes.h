// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/InventoryColumns.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace osgTreeWind {

/// A size of a tree in metres; 0 if it is not given.
struct InventorySize {
    float metres = 0.0f;
    bool isEstimate = false; ///< Whether it is the middle of a class, a bound, or approximate.
};

/// Reads tree sizes from an inventory: numbers, or words as parseSize() does. Markers for missing values,
/// such as 0, -99 or 999, and impossible sizes count as not given. It counts all these for notes and
/// problems.
class InventorySizes {
public:
    std::vector<double> missing; ///< Further numbers that mean "not measured", in the unit of the column.
    std::optional<bool>
        decimalComma; ///< Whether "20,15" is one number rather than two stems; empty: unknown.

    /// @param record largest size of the species, of which at most 1.5 times is possible; 0 if unknown.
    InventorySize read(const TreeRows& row, const MeasureColumn& measure, float record = 0.0f);

    /// Checks a size that the geometry gives, in metres. @param what for messages: "an outline".
    /// @return 0 if no tree has such a size.
    float readGeometry(const TreeRows& row, const MeasureColumn& measure, const char* what, double metres,
                       float record);

    /// A problem for each column in which most sizes cannot be read or are impossible, for example because of
    /// a wrong unit, or in which commas may separate numbers or be decimal.
    Diagnostics problems() const;
    /// Notes on sizes in words, and on those that count as not given, with the first of each.
    std::vector<std::string> notes() const;

private:
    /// Sizes of one kind in a column.
    struct Count {
        std::size_t rows = 0;
        Diagnostic first; ///< Of the first row.
    };
    struct Column {
        std::size_t used = 0, marked = 0, estimates = 0, withUnit = 0;
        Count words, impossible, unread;
        Count commas; ///< Those that may separate or be decimal.
        bool areSeparators = false, areDecimal = false;
        double unit = 1.0;
    };
    bool isMissingMark(double number) const;
    /// A size that is no number. @return empty if it is missing or cannot be read, and counts it.
    std::optional<SizeText> readWords(const TreeRows& row, const MeasureColumn& measure);
    /// The size, or 0 and a count if it is impossible.
    float checked(const MeasureColumn& measure, const Result<double>& metres);
    std::vector<std::string> counts(const Count Column::*count, const Diagnostic*& first) const;

    std::map<std::string_view, Column> _columns; ///< By key.
};

} // namespace osgTreeWind
