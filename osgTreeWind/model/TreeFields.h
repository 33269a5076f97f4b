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

/// Values that are in range but do not fit together. An empty key means the whole.
std::vector<FieldConflict> conflictsOf(const RecursiveTreeParameters& tree);
std::vector<FieldConflict> conflictsOf(const PalmParameters& palm);

} // namespace osgTreeWind
