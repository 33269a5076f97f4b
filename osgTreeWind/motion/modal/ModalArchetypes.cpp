// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalArchetypes.h>

#include <osgTreeWind/base/Jobs.h>

namespace osgTreeWind {

std::uint32_t ModalArchetypes::indexOf(const TreeForm& form) {
    const auto next = static_cast<std::uint32_t>(_archetypes.size() + _missing.size());
    const std::uint32_t index = _exact ? next : _indices.emplace(sizeClassOf(form), next).first->second;
    if (index == next)
        _missing.push_back(_exact ? form : typicalTree(sizeClassOf(form)));
    return index;
}

void ModalArchetypes::makeMissing(const Executor& executor) {
    if (_missing.empty())
        return;
    const std::size_t first = _archetypes.size();
    std::vector<TreeForm> missing;
    missing.swap(_missing);
    _archetypes.resize(first + missing.size());
    runJobs(executor, missing.size(),
            [&](std::size_t i) { _archetypes[first + i] = sharedArchetype(missing[i]); });
}

std::size_t ModalArchetypes::bytes() const {
    std::size_t bytes = 0;
    for (const auto& archetype : _archetypes)
        for (std::size_t level = 0; level < Archetype::levels; ++level) {
            const ModalModel& model = archetype->model(level);
            bytes += sizeof(float) * (model.poses.size() + model.levers.size() + model.brakes.size()) +
                     sizeof(ModalModel::Mode) * model.modes.size() +
                     sizeof(ModalModel::Patch) * model.patches.size();
        }
    return bytes;
}

} // namespace osgTreeWind
