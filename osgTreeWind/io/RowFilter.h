// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

class TreeRows;

/// A condition on the cells of a row, with the syntax of an SQL WHERE clause: comparisons, IN, LIKE, BETWEEN,
/// IS NULL, AND, OR, NOT and parentheses. Comparing an empty cell gives NULL, as in SQL.
class RowFilter {
public:
    /// Parses a condition. @param rows whose columns it may name. @return an error with a position.
    static Result<RowFilter> parse(const std::string& text, const TreeRows& rows);

    bool matches(const TreeRows& row) const { return _condition(row).value_or(false); }
    /// Columns that the condition uses, without duplicates.
    const std::vector<std::size_t>& columns() const { return _columns; }

    using Condition = std::function<std::optional<bool>(const TreeRows& row)>;

private:
    Condition _condition;
    std::vector<std::size_t> _columns;
};

} // namespace osgTreeWind
