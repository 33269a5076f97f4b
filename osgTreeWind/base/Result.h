// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// A problem found in an input, with its location.
struct OSGTREEWIND_EXPORT Diagnostic {
    std::string file;    ///< Path as given by the user; empty if the input is not a file.
    int line = 0;        ///< 1-based; 0 if unknown.
    int column = 0;      ///< 1-based, in bytes; 0 if unknown.
    std::string key;     ///< Dotted key or column name; may be empty.
    std::string message; ///< What is wrong and what was expected.

    /// "file:line:column: key: message", without the parts that are unknown.
    std::string text() const;
};

using Diagnostics = std::vector<Diagnostic>;

/// The texts of the problems, one per line, without a final line end.
OSGTREEWIND_EXPORT std::string toString(const Diagnostics& problems);

/// Reports on stderr that `value()` was called on an error. Stops the tests and the tool of this project.
OSGTREEWIND_EXPORT void logBadAccess(const Diagnostics& problems);

/// A value, or the problems that prevented it. Never throws.
///
///     auto file = readForestFile("wood.treewind");
///     if (!file)
///         return report(file.problems()); // each has a file, a line, a key and a text
///     description = file.value();
template <typename T>
class [[nodiscard]] Result {
public:
    Result(T value) : _value(std::move(value)) {}                 ///< Success.
    Result(Diagnostic problem) : _problems{std::move(problem)} {} ///< Error.
    /// @param problems at least one.
    Result(Diagnostics problems) : _problems(std::move(problems)) {}

    bool ok() const { return _problems.empty(); }   ///< Whether there is a value.
    explicit operator bool() const { return ok(); } ///< As ok().

    /// The value. For an error: T(), and a warning on stderr.
    T& value() {
        if (!ok())
            logBadAccess(_problems);
        return _value;
    }
    /// The value, as above.
    const T& value() const { return const_cast<Result*>(this)->value(); }

    /// All problems in the order of the input; empty if ok().
    const Diagnostics& problems() const { return _problems; }

private:
    T _value{};
    Diagnostics _problems;
};

} // namespace osgTreeWind
