// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/BranchSkin.h>

namespace osgTreeWind {

/// The skin of a joined skeleton, as makeBranchSkin() says.
BranchSkin makeJoinedSkin(const Skeleton& skeleton, float tolerance);

} // namespace osgTreeWind
