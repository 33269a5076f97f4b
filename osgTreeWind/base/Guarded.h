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

/// What the exception that is being handled says; "out of memory" of std::bad_alloc.
inline std::string messageOfException() noexcept {
    // Texts so short that a string holds them without memory.
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

/// Runs an entry, and `caught` while an exception of it is being handled. Lets a thread end that is
/// cancelled.
template <typename Entry, typename Caught>
void runCatching(const Entry& entry, const Caught& caught) {
    try {
        entry();
#if defined(__GLIBCXX__)
    } catch (const abi::__forced_unwind&) {
        throw;
#endif
    } catch (...) {
        caught();
    }
}

/// Runs an entry whose callers are not to get an exception. @return what its exception says; empty: there was
/// none.
template <typename Entry>
std::string runGuarded(const Entry& entry) {
    std::string problem;
    runCatching(entry, [&] { problem = messageOfException(); });
    return problem;
}

/// What such an entry returns, a Result or Diagnostics; of one that throws the Diagnostic that says why.
template <typename Entry>
auto guardedResult(const Entry& entry) {
    std::optional<decltype(entry())> result;
    const std::string problem = runGuarded([&] { result.emplace(entry()); });
    return problem.empty() ? std::move(*result) : decltype(entry()){keyProblem({}, problem)};
}

} // namespace osgTreeWind
