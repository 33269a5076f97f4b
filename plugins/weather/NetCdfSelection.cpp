// SPDX-License-Identifier: MIT
#include <plugins/weather/NetCdfSelection.h>

#include <algorithm>
#include <numeric>

namespace osgTreeWind {

namespace {

/// A run of consecutive indices along a dimension.
struct Run {
    std::size_t at = 0;    ///< Position in the selection.
    std::size_t first = 0; ///< Lowest index.
    std::size_t count = 1;
    bool downward = false;
};

std::vector<Run> runsOf(const std::vector<std::size_t>& indices) {
    std::vector<Run> runs;
    for (std::size_t at = 0; at < indices.size();) {
        Run run{at, indices[at], 1, at + 1 < indices.size() && indices[at + 1] + 1 == indices[at]};
        const auto follows = [&](std::size_t next) {
            return run.downward ? indices[next] + 1 == indices[next - 1]
                                : indices[next] == indices[next - 1] + 1;
        };
        for (std::size_t next = at + 1; next < indices.size() && follows(next); ++next)
            ++run.count;
        if (run.downward)
            run.first = indices[at + run.count - 1];
        at += run.count;
        runs.push_back(run);
    }
    return runs;
}

/// Advances to the next combination of indices, the last one fastest. @return false at the end.
bool advance(std::vector<std::size_t>& place, const std::vector<std::size_t>& sizes) {
    for (std::size_t d = place.size(); d-- > 0;) {
        if (++place[d] < sizes[d])
            return true;
        place[d] = 0;
    }
    return false;
}

/// Copies the numbers of a block to their positions in the selection.
void scatter(const std::vector<float>& block, const std::vector<Run>& runs,
             const std::vector<std::size_t>& strides, const std::vector<std::size_t>& counts,
             std::vector<float>& numbers) {
    std::vector<std::size_t> place(runs.size(), 0);
    for (const float number : block) {
        std::size_t to = 0;
        for (std::size_t d = 0; d < runs.size(); ++d)
            to += strides[d] * (runs[d].at + (runs[d].downward ? runs[d].count - 1 - place[d] : place[d]));
        numbers[to] = number;
        advance(place, counts);
    }
}

} // namespace

std::vector<std::size_t> allOf(std::size_t size) {
    std::vector<std::size_t> indices(size);
    std::iota(indices.begin(), indices.end(), std::size_t(0));
    return indices;
}

std::size_t countOf(const NetCdfSelection& selection) {
    std::size_t count = 1;
    for (const auto& indices : selection)
        count *= indices.size();
    return count;
}

std::size_t countOf(const NetCdfBlock& block) {
    std::size_t count = 1;
    for (const std::size_t size : block.counts)
        count *= size;
    return count;
}

bool readSelection(const NetCdfSelection& selection,
                   const std::function<bool(const NetCdfBlock&, float* numbers)>& read,
                   std::vector<float>& numbers) {
    numbers.resize(countOf(selection));
    if (numbers.empty())
        return true;
    std::vector<std::vector<Run>> runs;
    std::vector<std::size_t> strides(selection.size(), 1), runCounts;
    for (std::size_t d = selection.size(); d-- > 1;)
        strides[d - 1] = strides[d] * selection[d].size();
    for (const auto& indices : selection) {
        runs.push_back(runsOf(indices));
        runCounts.push_back(runs.back().size());
    }
    std::vector<std::size_t> chosen(selection.size(), 0);
    std::vector<float> numbersOfBlock;
    do {
        NetCdfBlock block;
        std::vector<Run> ofBlock;
        for (std::size_t d = 0; d < runs.size(); ++d) {
            ofBlock.push_back(runs[d][chosen[d]]);
            block.starts.push_back(ofBlock.back().first);
            block.counts.push_back(ofBlock.back().count);
        }
        numbersOfBlock.resize(countOf(block));
        if (!read(block, numbersOfBlock.data()))
            return false;
        scatter(numbersOfBlock, ofBlock, strides, block.counts, numbers);
    } while (advance(chosen, runCounts));
    return true;
}

} // namespace osgTreeWind
