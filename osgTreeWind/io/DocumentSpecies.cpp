// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/DocumentSpecies.h>

#include <osgTreeWind/base/Unicode.h>

#include <algorithm>

namespace osgTreeWind {

bool DocumentSpecies::reserveName(const std::string& name) {
    return _byName.emplace(foldedName(name), _all.size()).second;
}

void DocumentSpecies::endDeclared(bool inTables) {
    _declared = _all.size();
    _inTables = inTables;
}

std::optional<std::size_t> DocumentSpecies::find(const std::string& name) const {
    const auto found = _byName.find(foldedName(name));
    if (found == _byName.end())
        return std::nullopt;
    return found->second;
}

std::optional<std::size_t> DocumentSpecies::findOrAdd(const std::string& name) {
    if (const auto declared = find(name))
        return declared;
    return addBuiltIn(builtIn().find(name));
}

std::optional<std::size_t> DocumentSpecies::addBuiltIn(const Species* found) {
    if (!found)
        return std::nullopt;
    // The document's "oak" has precedence over a built-in "oak" that was found as "English oak".
    const auto [entry, isNew] = _byName.emplace(foldedName(found->name), _all.size());
    if (isNew) {
        std::vector<std::string>& aliases = _all.emplace_back(*found).aliases;
        const auto isUsed = [&](const std::string& alias) { return find(alias).has_value(); };
        aliases.erase(std::remove_if(aliases.begin(), aliases.end(), isUsed), aliases.end());
    }
    return entry->second;
}

const SpeciesCatalogue& DocumentSpecies::builtIn() {
    if (!_catalogue) {
        const Result<SpeciesCatalogue>& host = SpeciesCatalogue::hostCatalogue();
        for (const Diagnostic& problem : host.problems())
            _log.add(problem);
        _catalogue = host.ok() ? &host.value() : &SpeciesCatalogue::builtIn();
    }
    return *_catalogue;
}

} // namespace osgTreeWind
