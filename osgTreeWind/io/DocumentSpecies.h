// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/ReadLog.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// The species that a document declares, followed by the built-in ones that its trees need.
class DocumentSpecies {
public:
    /// @param all gets the species. @param log gets the problems with the host's catalogue file.
    /// @param catalogue of built-in species; null: that of the host. All must outlive this object.
    DocumentSpecies(std::vector<Species>& all, ReadLog& log, const SpeciesCatalogue* catalogue = nullptr)
        : _all(all), _log(log), _catalogue(catalogue) {}

    const std::vector<Species>& all() const { return _all; }
    /// Reserves a name or alias for the species that is added next. @return false if it is taken.
    bool reserveName(const std::string& name);
    void add(Species species) { _all.push_back(std::move(species)); }
    /// Ends the declarations. @param inTables the file has [[species]].
    void endDeclared(bool inTables);
    /// Number of species that the file declares.
    std::size_t declared() const { return _declared; }
    /// Whether the file declares a single species, which trees of unknown species have.
    bool isSingle() const { return _inTables && _declared == 1; }

    /// Index of the species with this name or alias, ignoring case.
    std::optional<std::size_t> find(const std::string& name) const;
    /// Index of the species with this name, or else of the built-in species, which is added if needed.
    std::optional<std::size_t> findOrAdd(const std::string& name);
    /// Adds a built-in species unless there is one of that name. @param found may be null.
    std::optional<std::size_t> addBuiltIn(const Species* found);
    /// The catalogue of built-in species.
    const SpeciesCatalogue& builtIn();

private:
    std::vector<Species>& _all;
    ReadLog& _log;
    const SpeciesCatalogue* _catalogue; ///< May be null until builtIn() is called.
    std::size_t _declared = 0;
    bool _inTables = false;
    std::map<std::string, std::size_t> _byName; ///< Folded names and aliases to indices.
};

} // namespace osgTreeWind
