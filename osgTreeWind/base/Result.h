// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <string>
#include <utility>
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

/// Their texts, a line each; the last one without its end.
OSGTREEWIND_EXPORT std::string linesOf(const Diagnostics& problems);

/// Says on stderr that somebody took the value of a Result that has none, and why it has none.
OSGTREEWIND_EXPORT void warnOfNoValue(const Diagnostics& problems);

/// A value, or the problems that kept it from being made. Never throws, never ends a program.
///
///     auto file = readForestFile("wood.treewind");
///     if (!file)
///         return report(file.problems()); // each has a file, a line, a key and a text
///     description = file.value();
template <typename T>
class [[nodiscard]] Result {
public:
    Result(T value) : _value(std::move(value)) {}                 ///< Succeeded.
    Result(Diagnostic problem) : _problems{std::move(problem)} {} ///< Failed.
    /// @param problems at least one.
    Result(Diagnostics problems) : _problems(std::move(problems)) {}

    bool ok() const { return _problems.empty(); }   ///< Whether there is a value.
    explicit operator bool() const { return ok(); } ///< The same.

    /// The value; where there is none an empty one, T(), with a warning on stderr.
    T& value() {
        if (!ok())
            warnOfNoValue(_problems);
        return _value;
    }
    /// The same of one that is kept.
    const T& value() const { return const_cast<Result*>(this)->value(); }

    /// All problems in the order of the input; none when ok().
    const Diagnostics& problems() const { return _problems; }

private:
    T _value{};
    Diagnostics _problems;
};

} // namespace osgTreeWind
