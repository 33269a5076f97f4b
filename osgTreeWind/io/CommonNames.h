// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace osgTreeWind {

/// The scientific name, or the genus, of a tree's common name in English, German, French, Spanish, Dutch or
/// Italian: osgTreeWind/species/names.csv. Empty where there is none.
const std::string& scientificName(const std::string& commonName);

/// The same of a kind that is not known but is called after one, which the end of its name says: "Kugelahorn"
/// and "river birch" are a maple and a birch. Empty where there is none.
const std::string& scientificNameOfKin(const std::string& commonName);

} // namespace osgTreeWind
