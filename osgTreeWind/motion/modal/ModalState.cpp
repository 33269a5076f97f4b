// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalState.h>

#include <osgTreeWind/base/ReserveGrowth.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstring>

namespace osgTreeWind {

void ModalGroup::reserve(std::size_t count) {
    const std::size_t blocks = (count + lanes - 1) / lanes;
    trees.reserve(count);
    waiting.reserve(blocks);
    numbers.reserve(blocks * treeFloats(model()));
}

std::size_t ModalGroup::add(std::uint32_t tree) {
    reserveGrowth(trees, trees.size() + 1);
    trees.push_back(tree);
    if (trees.size() > waiting.size() * lanes) {
        reserveGrowth(waiting, waiting.size() + 1);
        waiting.push_back(0.0f);
        const std::size_t size = waiting.size() * treeFloats(model());
        reserveGrowth(numbers, size);
        numbers.resize(size);
    }
    return trees.size() - 1;
}

void ModalGroup::remove(std::size_t place) {
    const std::size_t last = trees.size() - 1;
    for (std::size_t n = 0; n < treeFloats(model()); ++n) {
        number(place, n) = number(last, n);
        number(last, n) = 0.0f;
    }
    trees[place] = trees[last];
    trees.pop_back();
    if (trees.size() <= (waiting.size() - 1) * lanes) {
        waiting.pop_back();
        numbers.resize(waiting.size() * treeFloats(model()));
        if (2 * numbers.size() < numbers.capacity())
            numbers.shrink_to_fit();
    }
}

void ModalState::resize(std::size_t trees) {
    if (!slots.empty()) {
        reserveGrowth(slots, trees);
        reserveGrowth(places, trees);
        reserveGrowth(leans, trees);
    }
    slots.resize(trees);
    places.resize(trees);
    leans.resize(trees, glm::vec2(0.0f));
}

void ModalState::addToGroup(std::size_t tree, std::size_t group) {
    slots[tree] = {static_cast<std::uint32_t>(group),
                   static_cast<std::uint32_t>(groups[group].add(static_cast<std::uint32_t>(tree)))};
}

void ModalState::removeFromGroup(std::size_t tree) {
    const Slot slot = slots[tree];
    ModalGroup& group = groups[slot.group];
    slots[group.trees.back()].place = slot.place;
    group.remove(slot.place);
    slots[tree] = Slot();
}

TreeFactors ModalState::factors(std::size_t tree) const {
    const std::size_t first = groupOf(tree).firstFactor();
    float values[ModalGroup::factorCount];
    for (std::size_t n = 0; n < ModalGroup::factorCount; ++n)
        values[n] = number(tree, first + n);
    TreeFactors factors;
    std::memcpy(&factors, values, sizeof values);
    return factors;
}

void ModalState::setFactors(std::size_t tree, const TreeFactors& factors) {
    const std::size_t first = groupOf(tree).firstFactor();
    float values[ModalGroup::factorCount];
    std::memcpy(values, &factors, sizeof values);
    for (std::size_t n = 0; n < ModalGroup::factorCount; ++n)
        number(tree, first + n) = values[n];
}

const TreeFall* ModalState::fall(std::size_t tree) const {
    if (falls.empty())
        return nullptr;
    const auto fall = falls.find(static_cast<std::uint32_t>(tree));
    return fall == falls.end() ? nullptr : &fall->second;
}

/// Updates the lean. The horizontal displacement of a strongly bent tree is that of a circular arc.
void ModalState::updateLean(std::size_t tree) {
    const ModalGroup& group = groupOf(tree);
    const std::vector<glm::vec2>& modes = group.model().leans;
    const std::size_t place = slots[tree].place, factor = group.firstFactor();
    glm::vec2 lean(0.0f);
    for (std::size_t k = 0; k < modes.size(); ++k)
        lean += group.number(place, k) * modes[k];
    const float height = std::max(group.model().height, 1.0e-6f);
    lean *= swayShare(tree) * group.number(place, factor + 2) / // lengths
            std::sqrt(1.0f + glm::dot(lean, lean) / (height * height));
    const float cosine = group.number(place, factor), sine = group.number(place, factor + 1);
    leans[tree] = {cosine * lean.x - sine * lean.y, sine * lean.x + cosine * lean.y};
}

void ModalState::reset() {
    for (ModalGroup& group : groups) {
        for (std::size_t b = 0; b < group.waiting.size(); ++b)
            std::fill_n(group.block(b), group.firstFactor(), TreeLanes());
        std::fill(group.waiting.begin(), group.waiting.end(), 0.0f);
    }
    std::fill(leans.begin(), leans.end(), glm::vec2(0.0f));
    falls.clear();
}

std::size_t ModalState::bytes() const {
    std::size_t bytes = slots.capacity() * sizeof(Slot) + places.capacity() * sizeof(Place) +
                        leans.capacity() * sizeof(glm::vec2);
    for (const ModalGroup& group : groups)
        bytes += group.numbers.capacity() * sizeof(TreeLanes) +
                 group.trees.capacity() * sizeof(std::uint32_t) + group.waiting.capacity() * sizeof(float) +
                 group.stands.capacity() * sizeof(PlaceInStand);
    return bytes;
}

} // namespace osgTreeWind
