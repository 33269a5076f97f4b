// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/forest/ForestKeys.h>

#include <osg/ApplicationUsage>

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
} // namespace osgTreeWind
