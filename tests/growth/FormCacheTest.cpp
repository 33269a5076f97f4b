// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>
#include <tests/growth/HabitCases.h>
#include <tests/growth/SameForm.h>
#include <tests/io/FileBytes.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/base/DiskCache.h>
#include <osgTreeWind/growth/FormCache.h>
#include <osgTreeWind/growth/PackedForm.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <thread>
#include <vector>

namespace osgTreeWind {
namespace {

GrowthParameters smallOak(std::uint32_t seed) {
    GrowthParameters parameters;
    parameters.habit = oakHabit();
    parameters.size = {6.0f, 0.15f, 4.0f};
    parameters.seed = seed;
    return parameters;
}

} // namespace

TEST(FormCache, ReturnsAndStoresTheGrownForm) {
    const TemporaryFolder folder;
    const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", folder.path().c_str());
    const auto form = grownForm(smallOak(101));
    EXPECT_TRUE(sameBits(*form, growTree(smallOak(101))));
    EXPECT_EQ(form, grownForm(smallOak(101))) << "from memory";
    const auto stored = DiskCache(folder.path(), 1'000'000).find(formKey(smallOak(101)));
    ASSERT_TRUE(stored);
    EXPECT_TRUE(sameBits(*form, *unpackedForm(*stored)));
}

TEST(FormCache, ReadsStoredFormsAndReplacesDamagedOnes) {
    const TemporaryFolder folder;
    const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", folder.path().c_str());
    GrownForm other = growTree(smallOak(102));
    other.years = 12345;
    const DiskCache disk(folder.path(), 1'000'000);
    disk.store(formKey(smallOak(102)), packedForm(other));
    EXPECT_EQ(grownForm(smallOak(102))->years, 12345);
    disk.store(formKey(smallOak(103)), "no form at all");
    EXPECT_TRUE(sameBits(*grownForm(smallOak(103)), growTree(smallOak(103))));
    EXPECT_TRUE(unpackedForm(*disk.find(formKey(smallOak(103)))));
}

TEST(FormCache, KeyDependsOnEveryParameterOfTheShape) {
    std::set<std::string> keys{formKey(GrowthParameters())};
    std::size_t distinct = 1;
    const auto differs = [&](const GrowthParameters& parameters, const std::string& what) {
        keys.insert(formKey(parameters));
        EXPECT_EQ(keys.size(), ++distinct) << what;
    };
    for (const Key& each : keysOf<GrowthParameters>()) {
        const std::string key = each.name;
        if (key == "flare" || key == "model")
            continue;
        GrowthParameters changed;
        const Member member = each.of(&changed);
        if (const auto* number = std::get_if<float*>(&member))
            **number += 0.25f;
        else if (const auto* whole = std::get_if<int*>(&member))
            ++**whole;
        else if (const auto* seed = std::get_if<std::uint32_t*>(&member))
            ++**seed;
        else if (const auto* orders = std::get_if<std::array<float, 4>*>(&member))
            (**orders)[3] += 0.25f;
        else
            FAIL() << "no case for " << key;
        differs(changed, key);
    }
    GrowthParameters site;
    site.site.shade = 1.0f;
    differs(site, "shade");
    site.site.distance = 7.0f;
    differs(site, "distance");
    site.site.openSide = 0.0f;
    differs(site, "an open side");
    site.site.openSide = 1.0f;
    differs(site, "another side");
}

TEST(FormCache, GrowsTreesWithoutAFolder) {
    for (const char* place : {"off", "/proc/no/such", "/dev/full"}) {
        const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", place);
        GrowthParameters parameters = smallOak(104);
        parameters.size.height += 0.01f * static_cast<float>(std::string(place).size()); // not in memory yet
        EXPECT_TRUE(sameBits(*grownForm(parameters), growTree(parameters))) << place;
    }
}

TEST(FormCache, ConcurrentThreadsShareOneForm) {
    const TemporaryFolder folder;
    const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", folder.path().c_str());
    std::vector<std::shared_ptr<const GrownForm>> forms(8);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < forms.size(); ++i)
        threads.emplace_back([&, i] { forms[i] = grownForm(smallOak(i % 2 == 0 ? 105 : 106)); });
    for (std::thread& thread : threads)
        thread.join();
    for (std::size_t i = 2; i < forms.size(); ++i)
        EXPECT_EQ(forms[i], forms[i % 2]);
    EXPECT_EQ(folder.countFiles(), 2u);
}

} // namespace osgTreeWind
