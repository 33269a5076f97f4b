// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrownForm.h>
#include <osgTreeWind/growth/GrowthParameters.h>

#include <memory>
#include <string>

namespace osgTreeWind {

/// Result of growTree(), from a cache where possible. The process holds its latest forms in memory, and all
/// programs share the forms in the user's cache (base/UserCache.h). Thread-safe: if several threads request
/// the same form, one of them grows it and the others wait.
std::shared_ptr<const GrownForm> grownForm(const GrowthParameters& parameters);

/// Key of a form: binary, equal only for parameters and sources that grow the same form.
std::string formKey(const GrowthParameters& parameters);

} // namespace osgTreeWind
