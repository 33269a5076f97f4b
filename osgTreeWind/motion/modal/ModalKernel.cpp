// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalKernel.h>

#include <osgTreeWind/system/Program.h>

#include <algorithm>

namespace osgTreeWind {

// One source file per instruction set defines each of these.
void stepTreesBaseline(const ModalStep& step);
#ifdef OSGTREEWIND_X86_KERNELS
void stepTreesAvx2(const ModalStep& step);
void stepTreesAvx512(const ModalStep& step);
#endif

namespace {

constexpr InstructionSet all[] = {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512};

InstructionSet widest() {
#ifdef OSGTREEWIND_X86_KERNELS
    if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))
        return InstructionSet::Avx512;
    if (__builtin_cpu_supports("avx2"))
        return InstructionSet::Avx2;
#endif
    return InstructionSet::Baseline;
}

} // namespace

const char* nameOf(InstructionSet set) {
    constexpr const char* names[] = {"baseline", "avx2", "avx512"};
    return names[static_cast<std::size_t>(set)];
}

InstructionSet bestInstructionSet() {
    const std::optional<std::string> wanted = environmentVariable("OSGTREEWIND_INSTRUCTIONS");
    for (const InstructionSet set : all)
        if (wanted == nameOf(set))
            return std::min(set, widest());
    return widest();
}

void stepTrees(const ModalStep& step, InstructionSet set) {
#ifdef OSGTREEWIND_X86_KERNELS
    if (set == InstructionSet::Avx512)
        return stepTreesAvx512(step);
    if (set == InstructionSet::Avx2)
        return stepTreesAvx2(step);
#else
    (void)set;
#endif
    stepTreesBaseline(step);
}

} // namespace osgTreeWind
