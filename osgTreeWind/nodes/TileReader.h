// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// Has osgDB read `.trees` files, from folders and servers, as a TreeTile. Thread-safe; once is enough.
void registerTileReader();

} // namespace osgTreeWind
