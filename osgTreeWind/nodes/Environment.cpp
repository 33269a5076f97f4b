// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/Environment.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/forest/ForestKeys.h>

#include <osg/ApplicationUsage>
#include <osg/Notify>

#include <cstdlib>
#include <mutex>

namespace osgTreeWind {
namespace {

osg::ApplicationUsageProxy
    threadsUsage(osg::ApplicationUsage::ENVIRONMENTAL_VARIABLE, "OSGTREEWIND_THREADS <number>",
                 "Threads for osgTreeWind forests under the law modal. Default: one per processor. Results "
                 "do not depend on it.");
osg::ApplicationUsageProxy
    instructionsUsage(osg::ApplicationUsage::ENVIRONMENTAL_VARIABLE,
                      "OSGTREEWIND_INSTRUCTIONS <baseline|avx2|avx512>",
                      "The widest SIMD instructions for osgTreeWind forests under the law modal. Default: "
                      "the widest of the processor. Results do not depend on it.");
osg::ApplicationUsageProxy memoryUsage(
    osg::ApplicationUsage::ENVIRONMENTAL_VARIABLE, "OSGTREEWIND_MAX_MEMORY <bytes>",
    "Memory limit for an osgTreeWind forest, its ground, its wind data or a picture; k, M, G or T for larger "
    "units. Default: the available memory of the machine.");
osg::ApplicationUsageProxy stepUsage(osg::ApplicationUsage::ENVIRONMENTAL_VARIABLE,
                                     "OSGTREEWIND_STEP <seconds>",
                                     "Fixed duration of a frame for osgTreeWind forests. Default: the step "
                                     "of the file, or else the frame time of the host.");

} // namespace

double frameStepOf(const ForestDescription& description) {
    const char* text = std::getenv("OSGTREEWIND_STEP");
    if (!text || !*text)
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
