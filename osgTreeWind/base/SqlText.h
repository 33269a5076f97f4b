// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace osgTreeWind {

constexpr std::size_t maxSqlLength = 100000; ///< Of an expression, bytes.

/// Name of a column of the table `cells`: the cell, and its number or NULL. @param index in
/// SqlText::columns().
std::string sqlCell(std::size_t index);
std::string sqlNumber(std::size_t index);

/// Whether an expression may call the function: those whose value depends on nothing but their arguments.
bool isSqlFunction(const std::string& name);

/// The statement of SQL that an expression stands for. Only columns, literals, operators, the words of
/// expressions and allowed functions pass, so nothing else reaches the database.
class SqlText {
public:
    struct Problem {
        std::size_t at; ///< Byte of the text.
        std::string message;
    };

    /// @param file name of the table for messages.
    SqlText(const std::string& text, const std::vector<std::string>& columns, const std::string& file);

    const std::optional<Problem>& problem() const { return _problem; }
    /// "SELECT (...) FROM cells".
    const std::string& statement() const { return _sql; }
    /// Columns that the text names, without duplicates.
    const std::vector<std::size_t>& columns() const { return _used; }
    bool isColumn() const { return _isColumn; } ///< Whether the text is the name of a column.
    /// Position in the text of a position in the statement.
    std::size_t positionOf(std::size_t sqlPosition) const;
    /// The word or sign at a position of the text; empty at its end.
    std::string wordAt(std::size_t at) const;

private:
    std::size_t readQuoted(std::size_t at);
    std::size_t readWord(std::size_t at);
    std::size_t readSign(std::size_t at);
    void useColumn(std::size_t column, std::size_t end);
    void useName(const std::string& name, std::size_t at, std::size_t end);
    char signAfter(std::size_t at) const;
    std::size_t fail(std::size_t at, std::string message);

    const std::string& _text;
    const std::vector<std::string>& _names;
    const std::string& _file;
    std::string _sql = "SELECT (";
    std::vector<std::size_t> _used;
    std::vector<std::pair<std::size_t, std::size_t>> _positions; ///< In the statement, in the text.
    std::optional<Problem> _problem;
    std::string _lastWord; ///< In lower case; empty after a sign.
    char _lastSign = 0;    ///< 0 after a word.
    int _depth = 0, _calls = 0;
    bool _isColumn = false;
};

} // namespace osgTreeWind
