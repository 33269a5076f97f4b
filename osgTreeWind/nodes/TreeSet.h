// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// Some trees of a forest, each once, in any order. Adding and removing cost the same however many there are.
class TreeSet {
public:
    bool has(std::uint32_t tree) const { return tree < _places.size() && _places[tree] != 0; }
    std::size_t size() const { return _trees.size(); }

    void add(std::uint32_t tree) {
        if (has(tree))
            return;
        if (tree >= _places.size())
            _places.resize(tree + 1u);
        _trees.push_back(tree);
        _places[tree] = static_cast<std::uint32_t>(_trees.size());
    }
    void remove(std::uint32_t tree) {
        if (!has(tree))
            return;
        _trees[_places[tree] - 1] = _trees.back();
        _places[_trees.back()] = _places[tree];
        _trees.pop_back();
        _places[tree] = 0;
    }
    /// @param unwanted bool(tree).
    template<class Predicate> void removeIf(Predicate unwanted) {
        for (std::size_t i = _trees.size(); i-- > 0;)
            if (unwanted(_trees[i]))
                remove(_trees[i]);
    }

private:
    std::vector<std::uint32_t> _trees;
    std::vector<std::uint32_t> _places; ///< By tree, one more than its index; 0: not here.
};

} // namespace osgTreeWind
