// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace osgTreeWind {

/// The words of a text between blanks, one after the other, with the line of each. Bytes that are no text may
/// follow the part that is read. The text must outlive it.
class TextTokens {
public:
    /// @param file name for diagnostics only.
    TextTokens(std::string_view text, std::string file) : _text(text), _file(std::move(file)) {}

    /// The next word; empty at the end.
    std::string_view next();
    /// What is left of the line, without the line end; steps over it.
    std::string_view restOfLine();

    /// The next `count` bytes, whatever they are; fewer when there are not as many.
    std::string_view bytes(std::size_t count);

    /// The next word as a finite number within [low, high]; else a problem is kept and 0 given.
    double number(const char* what, double low, double high);
    /// The same for a whole number.
    int whole(const char* what, int low, int high);

    int line() const { return _line; } ///< Of the last word, 1-based.
    std::size_t offset() const {
        return _begin;
    } ///< Where the last word, or what follows the last line, begins.
    std::size_t left() const { return _text.size() - _at; } ///< Bytes behind the last word.

    bool good() const { return _problem.message.empty(); }
    const Diagnostic& problem() const { return _problem; } ///< The first problem; only when not good().
    /// Keeps a problem at the last word, unless there is one already.
    void fail(const std::string& message);

private:
    std::string_view _text;
    std::string _file;
    std::size_t _at = 0, _begin = 0;
    int _line = 1;
    Diagnostic _problem;
};

} // namespace osgTreeWind
