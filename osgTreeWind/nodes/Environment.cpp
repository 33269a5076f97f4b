// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/Environment.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/forest/ForestFields.h>

#include <osg/ApplicationUsage>
#include <osg/Notify>

#include <cstdlib>
#include <mutex>

namespace osgTreeWind {
namespace {

osg::ApplicationUsageProxy
    threadsUsage(osg::ApplicationUsage::ENVIRONMENTAL_VARIABLE, "OSGTREEWIND_THREADS <number>",
                 "Threads that step a large osgTreeWind forest under the law modal; else one for each "
                 "processor. Numbers do not depend on it.");
osg::ApplicationUsageProxy
    instructionsUsage(osg::ApplicationUsage::ENVIRONMENTAL_VARIABLE,
                      "OSGTREEWIND_INSTRUCTIONS <baseline|avx2|avx512>",
                      "The widest instructions that osgTreeWind forests under the law modal may use; else "
                      "what the processor has. Numbers do not depend on it.");
osg::ApplicationUsageProxy memoryUsage(
    osg::ApplicationUsage::ENVIRONMENTAL_VARIABLE, "OSGTREEWIND_MAX_MEMORY <bytes>",
    "Memory that an osgTreeWind forest, its ground, its wind data or a picture may need, with k, M, G or T "
    "for larger units. Default: what the machine has available.");

osg::ApplicationUsageProxy stepUsage(osg::ApplicationUsage::ENVIRONMENTAL_VARIABLE,
                                     "OSGTREEWIND_STEP <seconds>",
                                     "How long a frame lasts for osgTreeWind forests, whatever time the host "
                                     "gives; else as their files say, or the host.");

} // namespace

double frameStepOf(const ForestDescription& description) {
    const char* text = std::getenv("OSGTREEWIND_STEP");
    if (!text || !*text)
        return description.step;
    const std::optional<double> step = parseNumber(text);
    if (step && frameSteps.contains(*step))
        return *step;
    static std::once_flag said;
    std::call_once(said, [&] {
        OSG_WARN << "osgTreeWind: OSGTREEWIND_STEP: "
                 << expectedFound("seconds, a finite number " + frameSteps.text(), text) << "; it is not used"
                 << std::endl;
    });
    return description.step;
}

} // namespace osgTreeWind
