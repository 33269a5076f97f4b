// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Field.h>
#include <osgTreeWind/model/TreeModel.h>

namespace osgTreeWind {

template <>
const Fields& fieldsOf<RecursiveTreeParameters>();
template <>
const Fields& fieldsOf<PalmParameters>();
template <>
const Fields& fieldsOf<LeafParameters>();

/// What keeps numbers that are each in range from going together. A key of "" means the whole.
std::vector<FieldConflict> conflictsOf(const RecursiveTreeParameters& tree);
std::vector<FieldConflict> conflictsOf(const PalmParameters& palm);

} // namespace osgTreeWind
