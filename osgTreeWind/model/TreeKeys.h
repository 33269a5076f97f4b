// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Key.h>
#include <osgTreeWind/model/TreeModel.h>

namespace osgTreeWind {

template <>
const Keys& keysOf<RecursiveTreeParameters>();
template <>
const Keys& keysOf<PalmParameters>();
template <>
const Keys& keysOf<LeafParameters>();

/// Values that are in range but do not fit together. An empty key means the whole.
std::vector<KeyConflict> conflictsOf(const RecursiveTreeParameters& tree);
std::vector<KeyConflict> conflictsOf(const PalmParameters& palm);

} // namespace osgTreeWind
