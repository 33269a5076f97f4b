// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/portraits/Silhouette.h>

/// A mask without holes.
inline const osgTreeWind::Silhouette::Mask solidMask{1, {1}};
