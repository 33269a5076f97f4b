// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/SpeciesCatalogue.h>

#include <osgTreeWind/base/EmbeddedTexts.h>
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Trust.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/NameMatching.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace osgTreeWind {

namespace {

constexpr const char* fileName = "species.treewind";

/// The first one in the folders of OSG_FILE_PATH; empty: none.
std::filesystem::path fileOfHost() {
    std::error_code error;
    for (const std::string& folder : foldersOf("OSG_FILE_PATH"))
        if (auto path = std::filesystem::path(folder) / fileName;
            std::filesystem::is_regular_file(path, error))
            return path;
    return {};
}

Result<SpeciesCatalogue> readOfHost() {
    const std::filesystem::path path = fileOfHost();
    if (path.empty())
        return SpeciesCatalogue::builtIn();
    const Result<std::string> text = readTextFile(path.string());
    if (!text.ok())
        return text.problems();
    return SpeciesCatalogue::builtIn().with(text.value(), path.string(), path.parent_path().string());
}

bool isNamed(const Species& species, const std::string& folded) {
    return foldedName(species.name) == folded;
}

} // namespace

const SpeciesCatalogue& SpeciesCatalogue::builtIn() {
    static const SpeciesCatalogue catalogue = [] {
        const EmbeddedText* text = findEmbeddedText(std::string("osgTreeWind/species/") + fileName);
        return SpeciesCatalogue().with(text->text, text->name, "").value();
    }();
    return catalogue;
}

const Result<SpeciesCatalogue>& SpeciesCatalogue::ofHost() {
    static const Result<SpeciesCatalogue> catalogue = readOfHost();
    return catalogue;
}

const SpeciesCatalogue& SpeciesCatalogue::current() {
    static const SpeciesCatalogue& catalogue = []() -> const SpeciesCatalogue& {
        if (ofHost().ok())
            return ofHost().value();
        std::cerr << "osgTreeWind: " << ofHost().problems().front().text()
                  << "; the built-in species are used\n";
        return builtIn();
    }();
    return catalogue;
}

Result<SpeciesCatalogue> SpeciesCatalogue::with(const std::string& text, const std::string& file,
                                                const std::string& folder) const {
    SpeciesCatalogue catalogue = *this;
    ForestReading reading;
    reading.log.file = file;
    reading.folders = {folder};
    reading.catalogue = &catalogue;
    const auto& read = reading.forest.species;
    TableReader::readDocument(text, reading.log, [&](TableReader& root) {
        readVersion(root);
        root.tables("group", [&](TableReader& table) {
            readSpecies(table, reading);
            catalogue._groups[foldedName(read.back().name)] = read.back();
        });
        root.tables("species", [&](TableReader& table) {
            readSpecies(table, reading);
            for (const std::string& alias : read.back().aliases)
                if (const auto other = catalogue._byName.find(foldedName(alias));
                    other != catalogue._byName.end() &&
                    isNamed(catalogue._species[other->second], other->first))
                    table.problem("aliases", "the name " + inQuotes(alias) + " is taken already");
            catalogue.add(read.back());
        });
    });
    if (!reading.log.problems.empty())
        return std::move(reading.log.problems);
    return catalogue;
}

void SpeciesCatalogue::add(Species species) {
    const std::string name = foldedName(species.name);
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
    for (const std::string& own : names) {
        const std::string folded = foldedName(own);
        const auto [entry, isNew] = _byName.emplace(folded, index);
        if (isNew || entry->second == index)
            continue;
        std::vector<std::string>& others = _species[entry->second].aliases;
        others.erase(std::remove_if(others.begin(), others.end(),
                                    [&](const std::string& alias) { return foldedName(alias) == folded; }),
                     others.end());
        entry->second = index;
    }
    _species[index] = std::move(species);
}

const Species* SpeciesCatalogue::find(const std::string& name) const {
    const std::string folded = foldedName(name);
    auto found = _byName.find(folded);
    if (found == _byName.end())
        found = _byName.find(folded.substr(0, folded.find(' ')));
    return found == _byName.end() ? nullptr : &_species[found->second];
}

const Species* SpeciesCatalogue::findModel(const std::string& name) const {
    const auto group = _groups.find(foldedName(name));
    return group == _groups.end() ? find(name) : &group->second;
}

std::optional<Species> findSpecies(const std::string& name) {
    const Species* species = SpeciesCatalogue::current().find(name);
    return species ? std::optional(*species) : std::nullopt;
}

Species defaultSpecies() {
    return *findSpecies("broadleaf");
}

} // namespace osgTreeWind
