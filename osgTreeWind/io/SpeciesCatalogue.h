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

/// Species that need no [[species]], by name (docs/species.md). Any number of threads may read one.
///
///     if (const Species* oak = SpeciesCatalogue::current().find("Quercus robur"))
///         description.species.push_back(*oak);
class OSGTREEWIND_EXPORT SpeciesCatalogue {
public:
    /// The built-in species: osgTreeWind/species/species.treewind, as it was when the library was built.
    static const SpeciesCatalogue& builtIn();
    /// These with what the first species.treewind in the folders of the environment variable OSG_FILE_PATH
    /// adds or changes, or what is wrong with that file. Read by the first call in a process.
    static const Result<SpeciesCatalogue>& ofHost();
    /// That of the host; where its file is broken, the built-in one, and a warning on standard error, once.
    static const SpeciesCatalogue& current();

    /// This one with the species of a file. One of the name of a species here takes its place and keeps its
    /// aliases; others come last. An alias that another species has here is taken from it.
    /// `file` is for diagnostics, `folder` for relative paths in it. @return every problem otherwise.
    Result<SpeciesCatalogue> with(const std::string& text, const std::string& file,
                                  const std::string& folder) const;

    /// In the order of the files; in the built-in one conifers first, and the last two stand for any other
    /// conifer and any other broadleaf.
    const std::vector<Species>& species() const { return _species; }
    /// The species with this scientific name, or common name in English, German, French, Spanish, Dutch or
    /// Italian, else with its genus; with accents or not, in any case, and whatever cultivar follows. Null:
    /// none.
    const Species* find(const std::string& name) const;
    /// The species that a name which is not known is called after: a birch for "river birch". Null: none.
    const Species* findKin(const std::string& name) const;
    /// What `like` may name: a [[group]], or a species.
    const Species* findModel(const std::string& name) const;

private:
    void add(Species species);
    const Species* findExactly(const std::string& name) const;
    const Species* findScientific(const std::string& name) const; ///< Or its genus.
    const Species* findByAnyName(const std::string& name) const;  ///< A common one, too.

    std::vector<Species> _species;
    std::map<std::string, std::size_t> _byName; ///< By comparableName() of names and aliases.
    std::map<std::string, Species> _groups;     ///< Likewise.
};

/// SpeciesCatalogue::current().find() as a value.
OSGTREEWIND_EXPORT std::optional<Species> findSpecies(const std::string& name);

/// What stands for a tree of unknown species: "broadleaf".
OSGTREEWIND_EXPORT Species defaultSpecies();

} // namespace osgTreeWind
