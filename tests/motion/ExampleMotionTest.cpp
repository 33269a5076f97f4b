// SPDX-License-Identifier: MIT
// The motion of the examples has the same bits on every system.
#include <osgTreeWind/base/Digest.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <tests/Folders.h>

#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>

namespace osgTreeWind {
namespace {

struct Example {
    const char* file;
    std::vector<std::string> settings;
    const char* digest;
};

void PrintTo(const Example& example, std::ostream* output) {
    *output << example.file;
    for (const std::string& setting : example.settings)
        *output << ' ' << setting;
}

template <typename T>
void addTo(Digest& digest, const Span<T>& values) {
    digest.add(values.data, sizeof(T) * values.size);
}

std::string textOf(const Digest& digest) {
    std::ostringstream text;
    for (const unsigned char byte : digest.bytes())
        text << std::hex << std::setw(2) << std::setfill('0') << static_cast<int>(byte);
    return text.str();
}

class ExampleMotion : public ::testing::TestWithParam<Example> {};

TEST_P(ExampleMotion, HasTheBitsOfEverySystem) {
    auto read =
        readForestFile(OSGTREEWIND_SOURCE_DIR "/examples/" + std::string(GetParam().file) + ".treewind",
                       1000000, GetParam().settings);
    ASSERT_TRUE(read);
    auto created = ForestSimulation::create(std::move(read.value()));
    ASSERT_TRUE(created);
    ForestSimulation& simulation = *created.value();
    Digest digest;
    for (int step = 0; step <= 100; ++step) {
        simulation.advance(0.1 * step);
        if (step % 20 == 0)
            for (const TreeId tree : simulation.trees()) {
                const TreeMotion motion = simulation.motion(tree);
                addTo(digest, motion.poses);
                addTo(digest, motion.states);
                addTo(digest, motion.winds);
                addTo(digest, motion.leaves);
                addTo(digest, motion.pulls);
                if (const std::optional<TreeSway> sway = simulation.sway(tree))
                    digest.add(sway->windMoment);
            }
    }
    EXPECT_EQ(textOf(digest), GetParam().digest);
}

const Example examples[] = {
    {"forest", {}, "43d33212fec5c41481ef4eac100e0bb5"},
    {"forest",
     {"wind.strength=5", "wind.intensity=0.3", "motion.damage=true"},
     "f05dea50265ddad346fc9ce445aa993a"},
    {"forest",
     {"season=autumn", "wind.intensity=0.2", "wind.canopy=given"},
     "2c16b8cd4dc66244a44970c35de4ed5a"},
    {"explosion", {}, "29604355291b8ae050e846b65c77fca9"},
    {"helicopter", {}, "5212789b3fcc033f85b5be2b5dd4ba58"},
    {"lorry", {}, "e56f26bf8721716f0b5d20b51e25dd15"},
    {"thesis", {}, "98aa83fc580ab5b145dcf442ba9ca182"},
    {"thesis", {"motion.noise=1/f"}, "7462cd8f3f27d88e07c7be1e00167762"},
};
INSTANTIATE_TEST_SUITE_P(OfFiles, ExampleMotion, ::testing::ValuesIn(examples));

} // namespace
} // namespace osgTreeWind
