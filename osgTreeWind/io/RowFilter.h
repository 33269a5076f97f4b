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

/// A condition on the cells of a row, as behind SQL's WHERE: comparisons, IN, LIKE, BETWEEN, IS NULL, AND,
/// OR, NOT and brackets. What is compared with an empty cell is neither true nor false, as in SQL.
class RowFilter {
public:
    /// Understands a condition, or says where it does not: a problem that says at which character.
    /// @param rows whose columns it may name.
    static Result<RowFilter> parse(const std::string& text, const TreeRows& rows);

    bool matches(const TreeRows& row) const { return _condition(row).value_or(false); }
    /// Those that it names, each once.
    const std::vector<std::size_t>& columns() const { return _columns; }

    using Condition = std::function<std::optional<bool>(const TreeRows& row)>;

private:
    Condition _condition;
    std::vector<std::size_t> _columns;
};

} // namespace osgTreeWind
