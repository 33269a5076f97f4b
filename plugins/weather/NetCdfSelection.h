// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace osgTreeWind {

/// A selection of an array: indices along each dimension, in the order of the result.
using NetCdfSelection = std::vector<std::vector<std::size_t>>;

/// All indices of a dimension.
std::vector<std::size_t> allOf(std::size_t size);

std::size_t countOf(const NetCdfSelection& selection);

/// A contiguous block of an array.
struct NetCdfBlock {
    std::vector<unsigned long long> starts;
    std::vector<std::size_t> counts;
};

std::size_t countOf(const NetCdfBlock& block);

/// Reads a selection in blocks: one for each combination of ascending or descending runs of indices.
/// @param read reads one block in the order of the array; returns false to stop.
bool readSelection(const NetCdfSelection& selection,
                   const std::function<bool(const NetCdfBlock&, float* numbers)>& read,
                   std::vector<float>& numbers);

} // namespace osgTreeWind
