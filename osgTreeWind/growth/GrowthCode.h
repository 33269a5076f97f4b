// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// A text that is another one whenever the sources are by which trees grow, those of this room and of base.
/// Generated at build time.
const char* growthCode();

} // namespace osgTreeWind
