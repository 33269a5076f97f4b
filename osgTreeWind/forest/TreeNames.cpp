// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/TreeNames.h>

namespace osgTreeWind {

TreeNames& TreeNames::operator=(const TreeNames& other) {
    _slots = other._slots;
    _names.assign(other._names.size(), nullptr);
    for (const auto& [name, slot] : _slots)
        _names[slot] = &name;
    return *this;
}

bool TreeNames::set(std::uint32_t slot, const std::string& name) {
    if (slot < _names.size() && _names[slot]) {
        if (*_names[slot] == name)
            return true;
        _slots.erase(_slots.find(*_names[slot]));
        _names[slot] = nullptr;
    }
    if (name.empty())
        return true;
    const auto [entry, isNew] = _slots.emplace(name, slot);
    if (!isNew)
        return false;
    if (slot >= _names.size())
        _names.resize(slot + 1, nullptr);
    _names[slot] = &entry->first;
    return true;
}

std::optional<std::uint32_t> TreeNames::find(const std::string& name) const {
    const auto found = _slots.find(name);
    return found == _slots.end() ? std::nullopt : std::optional(found->second);
}

std::string TreeNames::of(std::uint32_t slot) const {
    return slot < _names.size() && _names[slot] ? *_names[slot] : std::string();
}

} // namespace osgTreeWind
