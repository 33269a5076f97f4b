// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace osgTreeWind {

/// Tokenizer of a text into words separated by white space, which keeps the first problem and its line.
/// Binary data may follow. The text must outlive the tokenizer.
class TextTokens {
public:
    /// @param file name for diagnostics only.
    TextTokens(std::string_view text, std::string file) : _text(text), _file(std::move(file)) {}

    /// The next word; empty at the end.
    std::string_view next();
    /// The rest of the line without its line end; skips the line end.
    std::string_view restOfLine();

    /// The next `count` bytes, or fewer at the end of the text.
    std::string_view bytes(std::size_t count);

    /// Parses the next word as a number in [low, high]; otherwise records a problem and returns 0.
    /// @param what names the expected number in the message.
    double number(const char* what, double low, double high);
    /// As number(), for an integer.
    int integer(const char* what, int low, int high);

    int line() const { return _line; } ///< Line of the last word, from 1.
    /// Offset of the last word, or of the line after restOfLine().
    std::size_t offset() const { return _begin; }
    std::size_t remaining() const { return _text.size() - _at; } ///< Bytes after the last word.

    bool good() const { return _problem.message.empty(); }
    const Diagnostic& problem() const { return _problem; } ///< The first problem, if not good().
    /// Records a problem at the last word, unless there is one already.
    void fail(const std::string& message);

private:
    std::string_view _text;
    std::string _file;
    std::size_t _at = 0, _begin = 0;
    int _line = 1;
    Diagnostic _problem;
};

} // namespace osgTreeWind
