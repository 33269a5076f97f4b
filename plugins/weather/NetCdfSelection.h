// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace osgTreeWind {

/// Which numbers of an array are wanted, in which order: indices along each of its dimensions.
using NetCdfSelection = std::vector<std::vector<std::size_t>>;

/// All of a dimension.
std::vector<std::size_t> allOf(std::size_t size);

std::size_t countOf(const NetCdfSelection& selection);

/// Numbers of an array that stand together in it.
struct NetCdfBlock {
    std::vector<unsigned long long> starts;
    std::vector<std::size_t> counts;
};

std::size_t countOf(const NetCdfBlock& block);

/// Reads a selection block by block: as few as its indices have runs, upward or downward.
/// @param read the numbers of one block, in the order of the array; false ends it.
bool readSelection(const NetCdfSelection& selection,
                   const std::function<bool(const NetCdfBlock&, float* numbers)>& read,
                   std::vector<float>& numbers);

} // namespace osgTreeWind
