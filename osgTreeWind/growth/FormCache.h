// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrownForm.h>
#include <osgTreeWind/growth/GrowthParameters.h>

#include <memory>
#include <string>

namespace osgTreeWind {

/// What growTree() gives for these parameters, or gave before: the process remembers the last forms, and a
/// folder those of all programs. The folder is `osgtreewind` in the user's cache (`XDG_CACHE_HOME`, or
/// `~/.cache`), or what the environment's OSGTREEWIND_FORM_CACHE names; its `off` does without. Any thread;
/// one grows a form, others that ask for it wait.
std::shared_ptr<const GrownForm> grownForm(const GrowthParameters& parameters);

/// What tells a form from all others, to the bit.
std::string formKey(const GrowthParameters& parameters);

/// Where forms are kept; empty: nowhere.
std::string formCacheFolder();

} // namespace osgTreeWind
