// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// The cells of the current row of a table.
class RowCells {
public:
    virtual ~RowCells() = default;
    virtual std::string text(std::size_t column) const = 0;
    /// Empty if the cell holds no finite number.
    virtual std::optional<double> number(std::size_t column) const = 0;
};

/// An SQL expression over the cells of a row, which SQLite evaluates in memory. It reads cells and nothing
/// else: no tables, files, times or random numbers. An empty cell is NULL. Division is that of real numbers.
class RowExpression {
public:
    enum class Kind { Value, Condition };
    struct Value {
        std::string text; ///< Empty for NULL.
        std::optional<double> number{};
    };

    /// @param columns of the table. @param file name for messages. @return an error with a position for
    /// anything but an expression that uses a column, and, for a condition, for a column alone.
    static Result<RowExpression> parse(const std::string& text, const std::vector<std::string>& columns,
                                       const std::string& file, Kind kind = Kind::Value);

    const std::string& text() const { return _text; }
    /// Columns that the expression uses, without duplicates.
    const std::vector<std::size_t>& columns() const;

    Result<Value> evaluate(const RowCells& row) const;
    /// Whether the value is true, not NULL.
    Result<bool> matches(const RowCells& row) const;

    struct Statement;

private:
    Diagnostics step(const RowCells& row) const;

    std::string _text;
    std::shared_ptr<Statement> _statement;
};

/// Whether a text is a name rather than an expression: it has no operator, bracket or quote.
bool mayBeColumn(const std::string& text);

/// A message that there is no such column, with the most similar name.
std::string problemOfColumn(const std::string& name, const std::vector<std::string>& columns,
                            const std::string& file);

} // namespace osgTreeWind
