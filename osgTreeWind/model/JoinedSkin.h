// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/BranchSkin.h>

namespace osgTreeWind {

/// The skin of a joined skeleton, as makeBranchSkin() says.
/// @param detail within its ranges.
BranchSkin makeJoinedSkin(const Skeleton& skeleton, const SkinDetail& detail);
SkinSize sizeOfJoinedSkin(const Skeleton& skeleton);

} // namespace osgTreeWind
