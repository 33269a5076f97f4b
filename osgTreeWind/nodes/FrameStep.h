// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

struct ForestDescription;

/// The fixed duration of a frame, seconds: the environment variable OSGTREEWIND_STEP if set, else
/// ForestDescription::step. 0: frames use the time of their stamp. An invalid variable is ignored, with one
/// OSG_WARN in the process.
double frameStepOf(const ForestDescription& description);

} // namespace osgTreeWind
