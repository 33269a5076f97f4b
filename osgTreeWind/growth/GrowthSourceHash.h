// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// Hash of the sources that determine how trees grow: those of the folders growth and base. Generated at
/// build time.
const char* growthSourceHash();

} // namespace osgTreeWind
