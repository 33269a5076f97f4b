// SPDX-License-Identifier: MIT
#include <tests/growth/HabitCases.h>
#include <tests/growth/SameForm.h>

#include <osgTreeWind/growth/PackedForm.h>

#include <gtest/gtest.h>

#include <limits>

namespace osgTreeWind {
namespace {

GrownForm anyForm(std::uint32_t seed) {
    GrowthParameters parameters;
    parameters.habit = anyHabit(seed);
    parameters.size = {6.0f, 0.15f, 3.5f};
    parameters.seed = seed;
    return growTree(parameters);
}

} // namespace

TEST(PackedForm, RestoresTheFormBitForBit) {
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        const GrownForm form = anyForm(seed);
        const std::string bytes = packedForm(form);
        EXPECT_LT(bytes.size(), 32 * form.metamers.size() + 200);
        const auto again = unpackedForm(bytes);
        ASSERT_TRUE(again) << seed;
        EXPECT_TRUE(sameBits(form, *again)) << seed;
    }
}

TEST(PackedForm, RestoresExtremeNumbers) {
    using Float = std::numeric_limits<float>;
    constexpr int largest = std::numeric_limits<int>::max();
    GrownForm form;
    form.years = largest;
    form.spread = Float::denorm_min();
    form.heightFactor = -0.0f;
    form.metamers.resize(3);
    form.metamers[1] = {{-0.0f, Float::denorm_min(), 1e30f}, 0, largest, largest, largest, true, 1e-30f};
    form.metamers[2].parent = 1;
    const auto again = unpackedForm(packedForm(form));
    ASSERT_TRUE(again);
    EXPECT_TRUE(sameBits(form, *again));
}

TEST(PackedForm, RefusesInvalidForms) {
    const GrownForm valid = anyForm(1);
    ASSERT_GT(valid.metamers.size(), 20u);
    const auto refuses = [&](auto change) {
        GrownForm form = valid;
        change(form.metamers[10]);
        return !unpackedForm(packedForm(form));
    };
    EXPECT_FALSE(refuses([](GrownMetamer&) {}));
    EXPECT_TRUE(refuses([](GrownMetamer& m) { m.parent = 10; })) << "its own parent";
    EXPECT_TRUE(refuses([](GrownMetamer& m) { m.parent = -1; })) << "a second foot";
    EXPECT_TRUE(refuses([](GrownMetamer& m) { m.axis = -1; }));
    EXPECT_TRUE(refuses([](GrownMetamer& m) { m.order = -1; }));
    EXPECT_TRUE(refuses([](GrownMetamer& m) { m.position.y = std::numeric_limits<float>::quiet_NaN(); }));
    EXPECT_TRUE(refuses([](GrownMetamer& m) { m.light = std::numeric_limits<float>::infinity(); }));
    EXPECT_FALSE(unpackedForm(packedForm(GrownForm()))) << "without a foot";
}

TEST(PackedForm, RefusesDamagedBytes) {
    const GrownForm form = anyForm(2);
    const std::string bytes = packedForm(form);
    for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 8)
        EXPECT_FALSE(unpackedForm(bytes.substr(0, size))) << size;
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        std::string damaged = bytes;
        const auto place = static_cast<std::size_t>(random.uniform() * static_cast<float>(bytes.size() - 1));
        damaged[place] = static_cast<char>(damaged[place] ^ (1 << (i % 8)));
        const auto again = unpackedForm(damaged); // some bits are unused
        EXPECT_TRUE(!again || sameBits(form, *again)) << "byte " << place;
    }
}

} // namespace osgTreeWind
