// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace osgTreeWind {

/// One problem found in an input: where it is, which key, and what was expected.
struct OSGTREEWIND_EXPORT Diagnostic {
    std::string file;    ///< Path as the user gave it; empty when the input is not a file.
    int line = 0;        ///< 1-based; 0 when unknown.
    int column = 0;      ///< 1-based; 0 when unknown.
    std::string key;     ///< Dotted key or column name the problem is about; may be empty.
    std::string message; ///< What is wrong and what was expected.

    /// "file:line:column: key: message", leaving out what is unknown.
    std::string text() const;
};

using Diagnostics = std::vector<Diagnostic>;

/// Ends the program for who takes a value that is not there: prints the problems on standard error, aborts.
[[noreturn]] OSGTREEWIND_EXPORT void abortWithoutValue(const Diagnostics& problems);

/// A value, or the problems that kept it from being made. Never throws.
template <typename T>
class Result {
public:
    Result(T value) : _content(std::move(value)) {}
    Result(Diagnostic problem) : _content(Diagnostics{std::move(problem)}) {}
    /// @param problems at least one.
    Result(Diagnostics problems) : _content(std::move(problems)) {}

    bool ok() const { return std::holds_alternative<T>(_content); }
    explicit operator bool() const { return ok(); }

    /// The value; without one the program ends with the problems on standard error, so ask ok() before.
    T& value() {
        if (!ok())
            abortWithoutValue(problems());
        return *std::get_if<T>(&_content);
    }
    const T& value() const { return const_cast<Result*>(this)->value(); }

    /// All problems in the order of the input; only when not ok().
    const Diagnostics& problems() const { return *std::get_if<Diagnostics>(&_content); }

private:
    std::variant<T, Diagnostics> _content;
};

} // namespace osgTreeWind
