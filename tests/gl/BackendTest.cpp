// SPDX-License-Identifier: MIT
// Compiled into each GL test program, with the backend and OpenGL library that the program is meant to have.
#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <gtest/gtest.h>
#ifndef _WIN32
#include <dlfcn.h>
#endif

#include <string>

TEST(Backend, isTheOneThatTheProgramLinks) {
    EXPECT_STREQ(osgTreeWind::offscreenBackendName(), EXPECTED_BACKEND);
}

#ifndef _WIN32 // where each function names its DLL
TEST(Backend, libraryIsWhereOsgFindsOpenGL) {
    Dl_info info{};
    ASSERT_NE(dladdr(dlsym(RTLD_DEFAULT, "glGetString"), &info), 0);
    EXPECT_NE(std::string(info.dli_fname).find(EXPECTED_LIBRARY), std::string::npos) << info.dli_fname;
}
#endif
