// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/FrameStep.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/forest/ForestKeys.h>
#include <osgTreeWind/system/Program.h>

#include <osg/Notify>

#include <mutex>

namespace osgTreeWind {

double frameStepOf(const ForestDescription& description) {
    const std::string text = environmentVariable("OSGTREEWIND_STEP").value_or("");
    if (text.empty())
        return description.step;
    const std::optional<double> step = parseNumber(text);
    if (step && frameSteps.contains(*step))
        return *step;
    static std::once_flag warned;
    std::call_once(warned, [&] {
        OSG_WARN << "osgTreeWind: OSGTREEWIND_STEP: "
                 << expectedFound("seconds, a finite number " + frameSteps.text(), text)
                 << "; the variable is ignored" << std::endl;
    });
    return description.step;
}

} // namespace osgTreeWind
