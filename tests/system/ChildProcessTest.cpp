// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/ChildProcess.h>
#include <osgTreeWind/system/Descriptor.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Program.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

namespace {

const std::string& testReader() {
    static const std::string path = toText(programPath().parent_path() / "test_reader") + programSuffix;
    return path;
}

} // namespace

TEST(ChildProcess, IsKilledWhileItWaits) {
    ChildProcess process;
    ASSERT_EQ(process.start(testReader(), {"file", "echo"}, ChildProcess::Connection::InputAndOutput), "");
    process.kill();
    char byte = 0;
    EXPECT_LE(readSome(process.descriptor(), &byte, 1), 0);
    EXPECT_LE(writeSome(process.descriptor(), &byte, 1), 0) << "and no signal ends this process";
    EXPECT_FALSE(process.finish().isSuccess);
}

TEST(ChildProcess, TellsItsEnd) {
    ChildProcess process;
    ASSERT_EQ(process.start(testReader(), {"file", "status"}, ChildProcess::Connection::InputAndOutput), "");
    const ChildProcess::End end = process.finish();
    EXPECT_FALSE(end.isSuccess);
    EXPECT_EQ(end.reason, "ended with status 3");
    EXPECT_EQ(process.finish().reason, "") << "a second time";
}

TEST(ChildProcess, IsNotStartedFromTheCurrentFolder) {
    ChildProcess process;
    EXPECT_NE(process.start("no such program", {}, ChildProcess::Connection::Input), "");
    EXPECT_LT(process.descriptor(), 0);
}

} // namespace osgTreeWind
