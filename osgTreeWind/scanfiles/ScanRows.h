// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/scanfiles/ScanQuantity.h>

#include <string_view>

namespace osgTreeWind {

/// Splits a text into lines of words, separated by blanks and commas. Skips empty lines and lines that begin
/// with #. The text must outlive it.
class ScanRows {
public:
    /// @param file name for diagnostics only.
    ScanRows(std::string_view text, std::string file) : _text(text), _file(std::move(file)) {}

    /// Advances to the next line. @return false at the end.
    bool next();
    const std::vector<std::string_view>& words() const { return _words; } ///< Words of the current line.
    int line() const { return _line; }                                    ///< 1-based.

    /// Parses a word as a finite number in its range. On failure it stores the problem and returns 0.
    double number(std::size_t word, const ScanQuantity& quantity);
    /// The same for a whole number within [low, high].
    int integer(std::size_t word, const char* description, int low, int high);

    bool good() const { return _problem.message.empty(); }
    const Diagnostic& problem() const { return _problem; } ///< The first problem; only if not good().
    /// Stores a problem of a word, unless there is one already.
    void fail(std::size_t word, const std::string& message);
    /// The same for the whole line.
    void failLine(const std::string& message);

private:
    std::string_view _text; ///< The lines that are not read yet.
    std::string _file;
    std::vector<std::string_view> _words;
    std::string_view _row;
    int _line = 0;
    Diagnostic _problem;
};

} // namespace osgTreeWind
