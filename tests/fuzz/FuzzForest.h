// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/ForestFile.h>

#include <cstdint>
#include <cstdlib>
#include <sstream>

/// Entry point that libFuzzer calls; see script/fuzz.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace osgTreeWind {

inline std::string textOf(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Aborts unless there is a problem with a message.
template <typename T>
void expectErrorHasMessage(const Result<T>& result) {
    if (!result && (result.problems().empty() || result.problems().front().message.empty()))
        std::abort();
}

/// Aborts unless the result is an error with a message, or a forest that stays the same when written and
/// read.
inline void expectForest(const std::string& document) {
    ForestFileOptions options;
    options.file = "fuzz";
    options.maxTrees = 2000;
    std::istringstream input(document);
    const auto forest = readForest(input, options);
    expectErrorHasMessage(forest);
    std::ostringstream written, again;
    if (!forest || !writeForest(forest.value(), written).empty())
        return;
    std::istringstream second(written.str());
    const auto read = readForest(second, options);
    if (!read || !writeForest(read.value(), again).empty() || again.str() != written.str())
        std::abort();
}

} // namespace osgTreeWind
