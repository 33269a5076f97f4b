// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>
#include <tests/base/FirstProblem.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/places/MapProgram.h>
#include <osgTreeWind/places/Raster.h>

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <thread>

#include <unistd.h>

namespace osgTreeWind {

namespace {

/// Running processes started by this thread.
std::vector<pid_t> children() {
    std::ifstream file("/proc/self/task/" + std::to_string(gettid()) + "/children");
    std::vector<pid_t> all;
    for (pid_t child = 0; file >> child;)
        all.push_back(child);
    return all;
}

/// The CRS as parsed by a program, or its error.
std::string textOf(MapProgram& program, const std::string& crs) {
    const auto facts = program.request<Crs::Facts>({MapRequest::Task::ParseCrs, {crs}});
    return facts ? facts.value().text : firstProblem(facts);
}

} // namespace

TEST(MapProgram, RunsFromTheFirstRequestUntilDestruction) {
    const std::vector<pid_t> before = children(); // may include the shared one
    {
        MapProgram program;
        EXPECT_EQ(children(), before) << "before the first request";
        EXPECT_EQ(textOf(program, "EPSG:25832"), "EPSG:25832");
        EXPECT_EQ(children().size(), before.size() + 1);
        EXPECT_EQ(textOf(program, "EPSG:25833"), "EPSG:25833");
        EXPECT_EQ(children().size(), before.size() + 1) << "one process for all requests";
    }
    EXPECT_EQ(children(), before);
}

TEST(MapProgram, RestartsAfterItWasKilled) {
    MapProgram program;
    ASSERT_EQ(textOf(program, "EPSG:25832"), "EPSG:25832");
    kill(children().back(), SIGKILL);
    EXPECT_EQ(textOf(program, "EPSG:25832"), "crs: cannot be read: its reader ended with: Killed");
    EXPECT_EQ(textOf(program, "EPSG:25832"), "EPSG:25832");
}

TEST(MapProgram, ReportsThePathOfAMissingProgram) {
    const EnvironmentVariable missing("OSGTREEWIND_MAP", "/nowhere/map");
    MapProgram program;
    const std::string reason =
        "reading maps needs GDAL, and the program /nowhere/map: No such file or directory";
    EXPECT_EQ(textOf(program, "EPSG:25832"), "crs: " + reason);
    const TemporaryFolder folder;
    const std::string file = folder.write("a.tif", "");
    EXPECT_EQ(firstProblem(Raster::open(file)), file + ": " + reason);
}

TEST(MapProgram, ReportsAProgramThatDoesNotAnswer) {
    const EnvironmentVariable silent("OSGTREEWIND_MAP", "/bin/true");
    const TemporaryFolder folder;
    const std::string file = folder.write("a.tif", "");
    EXPECT_EQ(firstProblem(Raster::open(file)), file + ": cannot be read: its reader ended with status 0");
}

TEST(MapProgram, ThreadsMayShareAProgram) {
    MapProgram program;
    std::vector<std::thread> threads;
    for (int zone = 1; zone <= 4; ++zone)
        threads.emplace_back([&program, zone] {
            const std::string text = "EPSG:" + std::to_string(32600 + zone);
            for (int i = 0; i < 50; ++i)
                EXPECT_EQ(textOf(program, text), text);
        });
    for (std::thread& thread : threads)
        thread.join();
}

} // namespace osgTreeWind
