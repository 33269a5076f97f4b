// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Field.h>
#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

template <>
const Fields& fieldsOf<HeightAllometry>();
template <>
const Fields& fieldsOf<CrownAllometry>();
template <>
const Fields& fieldsOf<WoodParameters>();
template <>
const Fields& fieldsOf<BranchParameters>();
template <>
const Fields& fieldsOf<LeafMotion>();
template <>
const Fields& fieldsOf<Appearance>();
/// All fields except the name and TreeParameters.
template <>
const Fields& fieldsOf<Species>();

} // namespace osgTreeWind
