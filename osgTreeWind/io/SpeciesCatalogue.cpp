// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/SpeciesCatalogue.h>

#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/EmbeddedTexts.h>
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Unicode.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/system/Path.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <unordered_map>

namespace osgTreeWind {

namespace {

constexpr const char* fileName = "species.treewind";

/// The first species.treewind in the folders of OSG_FILE_PATH; may be empty.
std::filesystem::path findHostFile() {
    std::error_code error;
    for (const std::string& folder : hostFolders())
        if (auto path = toPath(folder) / fileName; std::filesystem::is_regular_file(path, error))
            return path;
    return {};
}

bool isNamed(const Species& species, const std::string& comparable) {
    return comparableName(species.name) == comparable;
}

/// A name without cultivars and synonyms, as in "Acer platanoides 'Globosum'" and "Tilia cordata (Linde)".
std::string plainName(const std::string& name) {
    std::string plain = name.substr(0, name.find_first_of("('\"`"));
    for (const char* const quote : {" \xe2\x80\x98", " \xe2\x80\x9c", " \xe2\x80\x9e"})
        plain = plain.substr(0, plain.find(quote));
    return plain;
}

/// The first words of a folded name.
std::string firstWords(const std::string& name, int count) {
    std::size_t end = 0;
    for (; count > 0 && end < name.size(); --count)
        end = std::min(name.find_first_of(" ,", end + 1), name.size());
    return name.substr(0, end);
}

/// "plane" for "planetree" and "plane tree"; empty if the name does not end with "tree".
std::string withoutTree(const std::string& name) {
    constexpr std::string_view tree = "tree";
    if (name.size() <= tree.size() || name.compare(name.size() - tree.size(), tree.size(), tree) != 0)
        return {};
    return foldedName(name.substr(0, name.size() - tree.size()));
}

/// "Norway maple" for "Maple, Norway" and "Maple - Norway"; empty if the name has no such separator.
std::string reordered(const std::string& name) {
    for (const std::string& separator : {std::string(","), std::string(" - ")})
        if (const std::size_t at = name.find(separator); at != std::string::npos)
            return name.substr(at + separator.size()) + ' ' + name.substr(0, at);
    return {};
}

const std::string noName;

/// Calls `visitor` with each part of a cell such as "Zierkirsche|Kirsche".
template <typename Visitor>
void forEachPart(const std::string& cell, const Visitor& visitor) {
    for (std::size_t from = 0; from <= cell.size();) {
        const std::size_t to = std::min(cell.find('|', from), cell.size());
        if (to > from)
            visitor(cell.substr(from, to - from));
        from = to + 1;
    }
}

/// Scientific names by comparableName() of common ones.
const std::unordered_map<std::string, std::string>& scientificNames() {
    static const std::unordered_map<std::string, std::string> all = [] {
        std::unordered_map<std::string, std::string> names;
        const EmbeddedText* table = findEmbeddedText("osgTreeWind/species/names.csv");
        static_cast<void>(
            readCsvRows(table->text, table->name, ',', [&](const CsvTable&, CsvTable::Row& row) {
                for (std::size_t language = 1; language < row.cells.size(); ++language)
                    forEachPart(row.cells[language], [&](const std::string& name) {
                        names.emplace(comparableName(name), row.cells[0]);
                    });
            }));
        return names;
    }();
    return all;
}

const std::string& findScientificName(const std::string& comparable) {
    const auto found = scientificNames().find(comparable);
    return found == scientificNames().end() ? noName : found->second;
}

/// The scientific name, or genus, for a common name in English, German, French, Spanish, Dutch or Italian
/// (osgTreeWind/species/names.csv). Empty if the table does not have the name. Published lists confirm 720 of
/// the 907 names: American Forests, the Urban Tree Database, OKSTRA and GALK (German), INBO and Alterra
/// (Dutch), IFN4 (Spanish), and the tree inventories of Paris and Vienna. The other names are in common use.
const std::string& scientificName(const std::string& commonName) {
    return findScientificName(comparableName(commonName));
}

/// The scientific name for the longest common name that ends `name`: a maple for "Kugelahorn". May be empty.
const std::string& scientificNameOfSuffix(const std::string& name) {
    constexpr std::size_t minSuffix = 5, minPrefix = 3; // bytes
    const std::string comparable = comparableName(name);
    for (std::size_t begin = minPrefix; begin + minSuffix <= comparable.size(); ++begin) {
        const std::string suffix = comparable.substr(begin);
        if (const std::string& found = findScientificName(suffix); !found.empty())
            return found;
    }
    return noName;
}

} // namespace

const SpeciesCatalogue& SpeciesCatalogue::builtIn() {
    static const SpeciesCatalogue catalogue = [] {
        const EmbeddedText* text = findEmbeddedText(std::string("osgTreeWind/species/") + fileName);
        return SpeciesCatalogue().with(text->text, text->name, "").value();
    }();
    return catalogue;
}

bool SpeciesCatalogue::isCatalogue(const std::string& path) {
    return toPath(path).filename() == fileName;
}

Result<SpeciesCatalogue> SpeciesCatalogue::read(const std::string& path) {
    const Result<std::string> text = readTextFile(path);
    if (!text.ok())
        return text.problems();
    return builtIn().with(text.value(), path, folderOf(path));
}

const Result<SpeciesCatalogue>& SpeciesCatalogue::hostCatalogue() {
    static const Result<SpeciesCatalogue> catalogue = [] {
        const std::filesystem::path path = findHostFile();
        return path.empty() ? builtIn() : read(toText(path));
    }();
    return catalogue;
}

const SpeciesCatalogue& SpeciesCatalogue::current() {
    static const SpeciesCatalogue& catalogue = []() -> const SpeciesCatalogue& {
        if (hostCatalogue().ok())
            return hostCatalogue().value();
        std::cerr << "osgTreeWind: " << hostCatalogue().problems().front().text()
                  << "; the built-in species are used\n";
        return builtIn();
    }();
    return catalogue;
}

Result<SpeciesCatalogue> SpeciesCatalogue::with(const std::string& text, const std::string& file,
                                                const std::string& folder) const {
    SpeciesCatalogue catalogue = *this;
    ReadLog log;
    log.file = file;
    const InputFolders folders(folder);
    std::vector<Species> read;
    DocumentSpecies declared(read, log, &catalogue);
    TableReader::readDocument(text, log, [&](TableReader& root) {
        readVersion(root);
        root.tables("group", [&](TableReader& table) {
            readSpecies(table, folders, declared);
            catalogue._groups[comparableName(read.back().name)] = read.back();
        });
        root.tables("species", [&](TableReader& table) {
            readSpecies(table, folders, declared);
            for (const std::string& alias : read.back().aliases)
                if (const auto other = catalogue._byName.find(comparableName(alias));
                    other != catalogue._byName.end() &&
                    isNamed(catalogue._species[other->second], other->first))
                    table.problem("aliases", "the name " + inQuotes(alias) + " is taken already");
            catalogue.add(read.back());
        });
    });
    if (!log.problems.empty())
        return log.problems;
    return catalogue;
}

void SpeciesCatalogue::add(Species species) {
    const std::string name = comparableName(species.name);
    std::size_t index = _species.size();
    if (const auto known = _byName.find(name);
        known != _byName.end() && isNamed(_species[known->second], name)) {
        index = known->second;
        for (const std::string& alias : _species[index].aliases)
            if (std::find(species.aliases.begin(), species.aliases.end(), alias) == species.aliases.end())
                species.aliases.push_back(alias);
    } else {
        _species.emplace_back();
    }
    std::vector<std::string> names = species.aliases;
    names.push_back(species.name);
    for (const std::string& each : names) {
        const std::string folded = comparableName(each);
        const auto [entry, isNew] = _byName.emplace(folded, index);
        if (isNew || entry->second == index)
            continue;
        std::vector<std::string>& others = _species[entry->second].aliases;
        others.erase(
            std::remove_if(others.begin(), others.end(),
                           [&](const std::string& alias) { return comparableName(alias) == folded; }),
            others.end());
        entry->second = index;
    }
    _species[index] = std::move(species);
}

const Species* SpeciesCatalogue::findExactly(const std::string& name) const {
    const auto found = _byName.find(comparableName(name));
    return found == _byName.end() ? nullptr : &_species[found->second];
}

const Species* SpeciesCatalogue::findScientific(const std::string& name) const {
    if (name.empty())
        return nullptr;
    if (const Species* found = findExactly(name))
        return found;
    return findExactly(firstWords(foldedName(name), 1));
}

const Species* SpeciesCatalogue::findByAnyName(const std::string& name) const {
    if (name.empty())
        return nullptr;
    const Species* found = findExactly(name);
    return found ? found : findScientific(scientificName(name));
}

const Species* SpeciesCatalogue::find(const std::string& name) const {
    const std::string plain = plainName(name);
    for (const std::string& each : {name, plain, reordered(plain), firstWords(foldedName(plain), 2)}) {
        if (const Species* found = findByAnyName(each))
            return found;
    }
    return findByAnyName(firstWords(foldedName(plain), 1));
}

const Species* SpeciesCatalogue::findRelated(const std::string& name) const {
    std::string folded = foldedName(plainName(name));
    std::replace(folded.begin(), folded.end(), '-', ' ');
    for (std::size_t at = folded.find(' '); at != std::string::npos; at = folded.find(' ', at + 1)) {
        const std::string end = folded.substr(at + 1);
        for (const std::string& each : {end, withoutTree(end)})
            if (const Species* found = findByAnyName(each))
                return found;
    }
    return findScientific(scientificNameOfSuffix(folded));
}

const Species* SpeciesCatalogue::findTemplate(const std::string& name) const {
    const auto group = _groups.find(comparableName(name));
    return group == _groups.end() ? find(name) : &group->second;
}

std::optional<Species> findSpecies(const std::string& name) {
    const Species* species = SpeciesCatalogue::current().find(name);
    return species ? std::optional(*species) : std::nullopt;
}

std::string genericSpeciesNote(const std::string& name, const Species& found) {
    if ((found.name != "conifer" && found.name != "broadleaf") || isNamed(found, comparableName(name)))
        return {};
    return "the built-in species " + inQuotes(found.name) + " is used for " + inQuotes(name);
}

Species defaultSpecies() {
    return *findSpecies("broadleaf");
}

} // namespace osgTreeWind
