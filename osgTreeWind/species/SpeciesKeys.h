// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Key.h>
#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

template <>
const Keys& keysOf<HeightAllometry>();
template <>
const Keys& keysOf<CrownAllometry>();
template <>
const Keys& keysOf<WoodParameters>();
template <>
const Keys& keysOf<BranchParameters>();
template <>
const Keys& keysOf<LeafMotion>();
template <>
const Keys& keysOf<Appearance>();
/// All keys except the name and TreeParameters.
template <>
const Keys& keysOf<Species>();

} // namespace osgTreeWind
