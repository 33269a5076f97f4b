// SPDX-License-Identifier: MIT
// Damaged NetCDF-4 files, on which libhdf5 can crash: read or refused, without a crash of this process.
#include <tests/FullTests.h>
#include <tests/MissingReader.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/windfiles/NetCdfReading.h>

#include <netcdf.h>

#include <csignal>
#include <random>
#include <thread>

namespace osgTreeWind {

namespace {

/// A compressed NetCDF-4 file with u = x, v = y on 6 x 5 x 4 points.
std::string writeNetCdf4(const TemporaryFolder& folder) {
    const std::string path = folder.path() + "/whole.nc";
    const std::size_t sizes[] = {4, 5, 6};
    const char* const axes[] = {"z", "y", "x"};
    int file = 0, dimensions[3], coordinates[3], winds[2];
    int status = nc_create(path.c_str(), NC_NETCDF4 | NC_CLOBBER, &file);
    for (int axis = 0; axis < 3; ++axis) {
        status |= nc_def_dim(file, axes[axis], sizes[axis], &dimensions[axis]);
        status |= nc_def_var(file, axes[axis], NC_DOUBLE, 1, &dimensions[axis], &coordinates[axis]);
        status |= nc_put_att_text(file, coordinates[axis], "units", 1, "m");
    }
    for (int i = 0; i < 2; ++i) {
        status |= nc_def_var(file, i == 0 ? "u" : "v", NC_FLOAT, 3, dimensions, &winds[i]);
        status |= nc_put_att_text(file, winds[i], "units", 5, "m s-1");
        status |= nc_def_var_deflate(file, winds[i], 1, 1, 5);
    }
    std::vector<double> places(6);
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] = 10.0 * static_cast<double>(i);
    for (const int axis : coordinates)
        status |= nc_put_var_double(file, axis, places.data());
    std::vector<float> u, v;
    for (int i = 0; i < 4 * 5 * 6; ++i) {
        u.push_back(static_cast<float>(i % 6));
        v.push_back(static_cast<float>(i / 6 % 5));
    }
    status |= nc_put_var_float(file, winds[0], u.data());
    status |= nc_put_var_float(file, winds[1], v.data());
    status |= nc_close(file);
    EXPECT_EQ(status, NC_NOERR);
    return path;
}

} // namespace

TEST(NetCdfDamage, ReadsTheUndamagedFile) {
    const TemporaryFolder folder;
    const std::string path = writeNetCdf4(folder);
    REQUIRE_NETCDF(path);
    const auto file = readAt(path);
    ASSERT_TRUE(file) << firstProblem(file);
    EXPECT_EQ(file.value().summary.points, glm::ivec3(6, 5, 4));
    EXPECT_EQ(asField(file.value().wind)->velocity({25, 30, 10}, 0), glm::vec3(2.5f, 3, 0));
}

TEST(NetCdfDamage, ReadsOrRefusesDamagedFilesWithAReason) {
    const TemporaryFolder folder;
    const std::string path = writeNetCdf4(folder);
    REQUIRE_NETCDF(path);
    const std::string whole = fileBytes(path);
    std::mt19937 random(15);
    int ended = 0;
    for (int round = 0; round < casesToRun(200, 25); ++round) {
        std::string bytes = whole;
        for (unsigned changes = 1u << round % 5; changes > 0; --changes)
            bytes[random() % bytes.size()] = static_cast<char>(random());
        const auto file = readAt(folder.write("damaged.nc", bytes));
        if (file)
            continue;
        const std::string reason = firstProblem(file);
        EXPECT_NE(reason.substr(reason.size() - 2), ": ") << reason;
        ended += reason.find("the NetCDF file is damaged: ") != std::string::npos;
    }
    RecordProperty("readers_ended", ended);
}

/// With threads and signal settings as in a host.
TEST(NetCdfDamage, ThreadsReadConcurrently) {
    const TemporaryFolder folder;
    const std::string path = writeNetCdf4(folder);
    REQUIRE_NETCDF(path);
    const std::string cut = folder.write("cut.nc", fileBytes(path).substr(0, 3000));
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&] {
            EXPECT_TRUE(readAt(path));
            EXPECT_FALSE(readAt(cut));
        });
    for (std::thread& thread : threads)
        thread.join();
    const auto before = std::signal(SIGCHLD, SIG_IGN); // makes waitpid() fail
    EXPECT_TRUE(readAt(path));
    EXPECT_FALSE(readAt(cut));
    std::signal(SIGCHLD, before);
}

TEST(NetCdfDamage, NamesTheMissingReaderProgram) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.nc", "CDF\1");
    expectMissingReaderError("OSGTREEWIND_WEATHER", path, "NetCDF", "GDAL",
                             [&] { return firstProblem(readAt(path)); });
}

} // namespace osgTreeWind
