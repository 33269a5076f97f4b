// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace osgTreeWind {

/// The scientific name, or genus, for a common name in English, German, French, Spanish, Dutch or Italian
/// (osgTreeWind/species/names.csv). Empty if the table does not have the name. Of 907 names, 720 were
/// confirmed in the species lists of American Forests and the Urban Tree Database, OKSTRA and GALK (German),
/// INBO and Alterra (Dutch), IFN4 (Spanish), and the tree inventories of Paris and Vienna; the others are in
/// common use.
const std::string& scientificName(const std::string& commonName);

/// The scientific name for the longest common name that ends `name`: a maple for "Kugelahorn". May be empty.
const std::string& scientificNameOfSuffix(const std::string& name);

} // namespace osgTreeWind
