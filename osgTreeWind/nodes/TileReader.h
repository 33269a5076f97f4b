// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// Has osgDB read files of a world, from folders and servers: `.trees` as a TreeTile, `.crowns` as a
/// CrownFile, `.ids` as an IdFile. Thread-safe; once is enough.
void registerTileReader();

} // namespace osgTreeWind
