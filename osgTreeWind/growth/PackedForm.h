// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrownForm.h>

#include <optional>
#include <string>

namespace osgTreeWind {

/// Compresses a form, losslessly. The bytes are in the machine's byte order.
std::string packedForm(const GrownForm& form);

/// Inverse of packedForm(). Nullopt unless the bytes are a form with finite numbers whose metamers precede
/// their children.
std::optional<GrownForm> unpackedForm(const std::string& bytes);

} // namespace osgTreeWind
