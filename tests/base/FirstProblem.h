// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <string>

/// The text of a result's first problem; empty if it is ok.
template <typename T>
std::string firstProblem(const osgTreeWind::Result<T>& result) {
    return result.ok() ? std::string() : result.problems().front().text();
}
