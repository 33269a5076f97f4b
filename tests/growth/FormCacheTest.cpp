// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>
#include <tests/growth/HabitCases.h>
#include <tests/growth/SameForm.h>
#include <tests/io/FileBytes.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/growth/FormCache.h>
#include <osgTreeWind/growth/FormFolder.h>
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

std::size_t keptIn(const std::string& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

} // namespace

TEST(FormCache, AFormIsWhatGrowsAndIsKept) {
    const TemporaryFolder folder;
    const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", folder.path().c_str());
    const auto form = grownForm(smallOak(101));
    EXPECT_TRUE(sameBits(*form, growTree(smallOak(101))));
    EXPECT_EQ(form, grownForm(smallOak(101))) << "the process remembers it";
    const auto kept = FormFolder(folder.path(), 1'000'000).find(formKey(smallOak(101)));
    ASSERT_TRUE(kept);
    EXPECT_TRUE(sameBits(*form, *unpackedForm(*kept)));
}

TEST(FormCache, WhatIsKeptIsTaken) {
    const TemporaryFolder folder;
    const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", folder.path().c_str());
    GrownForm other = growTree(smallOak(102)); // told from what would grow by its age
    other.years = 12345;
    const FormFolder kept(folder.path(), 1'000'000);
    kept.keep(formKey(smallOak(102)), packedForm(other));
    EXPECT_EQ(grownForm(smallOak(102))->years, 12345);
    kept.keep(formKey(smallOak(103)), "no form at all");
    EXPECT_TRUE(sameBits(*grownForm(smallOak(103)), growTree(smallOak(103))));
    EXPECT_TRUE(unpackedForm(*kept.find(formKey(smallOak(103))))) << "the damaged one has been written anew";
}

TEST(FormCache, EachNumberThatShapesATreeTellsItFromOthers) {
    const GrowthParameters usual;
    std::set<std::string> keys{formKey(usual)};
    std::size_t distinct = 1;
    const auto differs = [&](const GrowthParameters& parameters, const std::string& what) {
        keys.insert(formKey(parameters));
        EXPECT_EQ(keys.size(), ++distinct) << what;
    };
    for (const Field& field : fieldsOf<GrowthParameters>()) {
        const std::string key = field.key;
        if (key == "flare" || key == "model")
            continue;
        GrowthParameters changed;
        const Member member = field.of(&changed);
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

TEST(FormCache, IsWhereTheEnvironmentSays) {
    {
        const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", "off");
        EXPECT_EQ(formCacheFolder(), "");
    }
    const EnvironmentVariable none("OSGTREEWIND_FORM_CACHE", "");
    const EnvironmentVariable home("HOME", "/home/somebody");
    {
        const EnvironmentVariable caches("XDG_CACHE_HOME", "/var/caches");
        EXPECT_EQ(formCacheFolder(), "/var/caches/osgtreewind");
    }
    const EnvironmentVariable relative("XDG_CACHE_HOME", "here");
    EXPECT_EQ(formCacheFolder(), "/home/somebody/.cache/osgtreewind")
        << "one that is not absolute is not meant";
    const EnvironmentVariable nobody("HOME", "");
    const EnvironmentVariable local("LOCALAPPDATA", "");
    EXPECT_EQ(formCacheFolder(), "");
}

TEST(FormCache, WithoutAFolderTreesGrow) {
    for (const char* place : {"off", "/proc/no/such", "/dev/full"}) {
        const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", place);
        GrowthParameters parameters = smallOak(104);
        parameters.size.height += 0.01f * static_cast<float>(std::string(place).size()); // one not yet known
        EXPECT_TRUE(sameBits(*grownForm(parameters), growTree(parameters))) << place;
    }
}

TEST(FormCache, ThreadsThatAskAtOnceGetOneForm) {
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
    EXPECT_EQ(keptIn(folder.path()), 2u);
}

} // namespace osgTreeWind
