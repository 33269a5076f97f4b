// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Problem.h>

#include <exception>
#include <new>
#include <optional>
#include <string>
#include <utility>

#if defined(__GLIBCXX__)
#include <cxxabi.h>
#endif

namespace osgTreeWind {

/// The message of the exception being handled; "out of memory" for std::bad_alloc.
inline std::string currentExceptionMessage() noexcept {
    // The literals are short enough for std::string to hold without allocating.
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return "out of memory";
    } catch (const std::exception& exception) {
        try {
            return exception.what();
        } catch (...) {
            return "out of memory";
        }
    } catch (...) {
        return "unknown error";
    }
}

/// Calls `function`. If it throws, calls `onException` in the handler. Does not stop pthread cancellation.
template <typename Function, typename OnException>
void runCatching(const Function& function, const OnException& onException) {
    try {
        function();
#if defined(__GLIBCXX__)
    } catch (const abi::__forced_unwind&) {
        throw;
#endif
    } catch (...) {
        onException();
    }
}

/// Calls `function` and catches its exceptions. @return the exception's message, or an empty text.
template <typename Function>
std::string runGuarded(const Function& function) {
    std::string problem;
    runCatching(function, [&] { problem = currentExceptionMessage(); });
    return problem;
}

/// The Result or Diagnostics that `function` returns. An exception becomes a Diagnostic.
template <typename Function>
auto guardedResult(const Function& function) {
    std::optional<decltype(function())> result;
    const std::string problem = runGuarded([&] { result.emplace(function()); });
    return problem.empty() ? std::move(*result) : decltype(function()){keyProblem({}, problem)};
}

} // namespace osgTreeWind
