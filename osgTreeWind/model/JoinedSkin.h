// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/BranchSkin.h>

namespace osgTreeWind {

/// Makes the bark of a joined skeleton; see makeBranchSkin().
BranchSkin makeJoinedSkin(const Skeleton& skeleton, float tolerance);

} // namespace osgTreeWind
