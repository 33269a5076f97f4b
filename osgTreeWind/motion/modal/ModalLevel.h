// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace osgTreeWind {

/// How closely the law `modal` follows a tree.
enum class ModalLevel : std::uint8_t {
    Near, ///< Up to 12 modes, 12 patches, every step.
    Far   ///< Up to 4 modes, 4 patches, a step each fifth of a second (ModalMotion::farStep).
};

} // namespace osgTreeWind
