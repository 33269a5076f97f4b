// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/species/Species.h>

#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// A species that needs no [[species]]: form, wood and drag from published tables (docs/validation.md names
/// each).
struct BuiltInSpecies {
    std::vector<std::string> names; ///< Common name first, then others and scientific ones.
    Species species;                ///< Under the common name.
    std::string source;             ///< Of its wood and drag.
};

/// All of them, conifers first; the last two stand for any other conifer and any other broadleaf.
/// Made anew by each call.
OSGTREEWIND_EXPORT std::vector<BuiltInSpecies> builtInSpecies();

/// The species with this common or scientific name, whatever its case.
OSGTREEWIND_EXPORT std::optional<Species> findBuiltInSpecies(const std::string& name);

/// What stands for a tree of unknown species: "broadleaf".
OSGTREEWIND_EXPORT Species defaultSpecies();

} // namespace osgTreeWind
