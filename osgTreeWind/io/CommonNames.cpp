// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/CommonNames.h>

#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/EmbeddedTexts.h>
#include <osgTreeWind/base/Unicode.h>

#include <algorithm>
#include <unordered_map>

namespace osgTreeWind {

namespace {

const std::string none;

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

const std::string& find(const std::string& comparable) {
    const auto found = scientificNames().find(comparable);
    return found == scientificNames().end() ? none : found->second;
}

} // namespace

const std::string& scientificName(const std::string& commonName) {
    return find(comparableName(commonName));
}

const std::string& scientificNameOfSuffix(const std::string& name) {
    constexpr std::size_t minSuffix = 5, minPrefix = 3; // bytes
    const std::string comparable = comparableName(name);
    for (std::size_t begin = minPrefix; begin + minSuffix <= comparable.size(); ++begin) {
        const std::string suffix = comparable.substr(begin);
        if (const std::string& found = find(suffix); !found.empty())
            return found;
    }
    return none;
}

} // namespace osgTreeWind
