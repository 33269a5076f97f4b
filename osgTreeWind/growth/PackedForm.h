// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrownForm.h>

#include <optional>
#include <string>

namespace osgTreeWind {

/// A form as few bytes, of which unpackedForm() makes the same form, bit for bit. In the order of bytes of
/// this machine.
std::string packedForm(const GrownForm& form);

/// None where the bytes are not those of a form: its metamers are in their order, and all numbers are finite.
std::optional<GrownForm> unpackedForm(const std::string& bytes);

} // namespace osgTreeWind
