// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/species/Species.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Species that can be used by name, without [[species]] (docs/species.md). Threads may share it.
///
///     if (const Species* oak = SpeciesCatalogue::current().find("Quercus robur"))
///         description.species.push_back(*oak);
class OSGTREEWIND_EXPORT SpeciesCatalogue {
public:
    /// The built-in species (osgTreeWind/species/species.treewind, compiled into the library).
    static const SpeciesCatalogue& builtIn();
    /// Whether a file has the name of a catalogue, species.treewind.
    static bool isCatalogue(const std::string& path);
    /// The built-in species, extended or changed by a species.treewind file. @return all problems.
    static Result<SpeciesCatalogue> read(const std::string& path);
    /// What read() returns for the first species.treewind in the folders of the environment variable
    /// OSG_FILE_PATH; the built-in species if there is none. Read once per process.
    static const Result<SpeciesCatalogue>& hostCatalogue();
    /// The host's catalogue. If its file is invalid: the built-in one, with one warning on standard error.
    static const SpeciesCatalogue& current();

    /// A copy of this catalogue with the species of a file. A species with the name of an existing one
    /// replaces it and keeps its aliases; others are appended. Aliases move to new species.
    /// @param text of a species.treewind file. @param file name for diagnostics. @param folder for relative
    /// paths. @return all problems.
    Result<SpeciesCatalogue> with(const std::string& text, const std::string& file,
                                  const std::string& folder) const;

    /// In the order of the files. The built-in file has conifers first, and its last two species stand for
    /// any other conifer and any other broadleaf.
    const std::vector<Species>& species() const { return _species; }
    /// Finds a species by its scientific name or a common name in English, German, French, Spanish, Dutch or
    /// Italian, or else by its genus. Ignores accents, case and cultivars. Null if there is none.
    const Species* find(const std::string& name) const;
    /// Finds a related species for an unknown name by its last words: a birch for "river birch". May be null.
    const Species* findRelated(const std::string& name) const;
    /// Finds the [[group]] or species that the key `like` names. May be null.
    const Species* findTemplate(const std::string& name) const;

private:
    void add(Species species);
    const Species* findExactly(const std::string& name) const;
    const Species* findScientific(const std::string& name) const; ///< By scientific name or genus.
    const Species* findByAnyName(const std::string& name) const;  ///< Also by common name.

    std::vector<Species> _species;
    std::map<std::string, std::size_t> _byName; ///< By comparableName() of names and aliases.
    std::map<std::string, Species> _groups;     ///< By comparableName().
};

/// SpeciesCatalogue::current().find() as a value.
OSGTREEWIND_EXPORT std::optional<Species> findSpecies(const std::string& name);

/// A note if find() returned "conifer" or "broadleaf" for the name of another species; else empty.
OSGTREEWIND_EXPORT std::string genericSpeciesNote(const std::string& name, const Species& found);

/// The species used for trees of unknown species: "broadleaf".
OSGTREEWIND_EXPORT Species defaultSpecies();

} // namespace osgTreeWind
