// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/scanfiles/ScanMeasures.h>

#include <string_view>

namespace osgTreeWind {

/// The lines of a text one after the other as words between blanks and commas, without empty lines and those
/// that begin with #. The text must outlive it.
class ScanRows {
public:
    /// @param file name for diagnostics only.
    ScanRows(std::string_view text, std::string file) : _text(text), _file(std::move(file)) {}

    /// Goes on to the next line. False at the end.
    bool next();
    const std::vector<std::string_view>& words() const { return _words; } ///< Of this line.
    int line() const { return _line; }                                    ///< 1-based.

    /// A word as a finite number in its range; else a problem is kept and 0 given.
    double number(std::size_t word, const ScanMeasure& measure);
    /// The same for a whole number within [low, high].
    int whole(std::size_t word, const char* what, int low, int high);

    bool good() const { return _problem.message.empty(); }
    const Diagnostic& problem() const { return _problem; } ///< The first problem; only when not good().
    /// Keeps a problem with a word, unless there is one already.
    void fail(std::size_t word, const std::string& message);
    /// The same with the line as a whole.
    void failLine(const std::string& message);

private:
    std::string_view _text; ///< What is left of it.
    std::string _file;
    std::vector<std::string_view> _words;
    std::string_view _row;
    int _line = 0;
    Diagnostic _problem;
};

} // namespace osgTreeWind
