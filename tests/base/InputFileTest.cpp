// SPDX-License-Identifier: MIT
#include <tests/base/FirstProblem.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/places/Raster.h>
#include <osgTreeWind/places/VectorFile.h>
#include <osgTreeWind/scanfiles/ScanFile.h>
#include <osgTreeWind/windfiles/WindFile.h>

#include <gtest/gtest.h>

#ifndef _WIN32
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>
#endif

using namespace osgTreeWind;

TEST(InputFile, ReadsRegularFiles) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a", "text");
    EXPECT_EQ(readTextFile(path).value(), "text");
    EXPECT_EQ(firstProblem(readTextFile(folder.path() + "/b")), folder.path() + "/b: no such file");
    EXPECT_EQ(firstProblem(readTextFile("")), "no such file");
}

#ifndef _WIN32 // where pipes, sockets and devices are no files of a folder
/// Reading a pipe without a writer would block, and reading /dev/zero would never end.
TEST(InputFile, AllReadersRejectPipesSocketsFoldersAndDevices) {
    const TemporaryFolder folder;
    const std::string pipe = folder.path() + "/pipe", socketPath = folder.path() + "/s";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int descriptor = socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    ASSERT_LT(socketPath.size(), sizeof address.sun_path);
    socketPath.copy(address.sun_path, socketPath.size());
    ASSERT_EQ(bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    for (const std::string& path : {pipe, socketPath, folder.path(), std::string("/dev/zero")}) {
        const std::string problem = path + ": not a regular file";
        EXPECT_EQ(firstProblem(openInput(path)), problem);
        EXPECT_EQ(firstProblem(readForestFile(path)), problem);
        EXPECT_EQ(firstProblem(readScanFile(path)), problem);
        EXPECT_EQ(firstProblem(readWindFile(path)), problem);
        EXPECT_EQ(firstProblem(Raster::open(path)), problem);
        EXPECT_EQ(firstProblem(VectorFile::open(path)), problem);
    }
    close(descriptor);
}
#endif
