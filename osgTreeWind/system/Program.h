// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// The file of the running program.
std::filesystem::path programPath();
/// The file of the library or program that contains this function.
std::filesystem::path libraryPath();
/// What follows the name of an executable file: ".exe", or nothing.
extern const char programSuffix[];
/// Searches the folders of the environment variable PATH for a program, but never the current folder.
/// @return its path in UTF-8; empty if there is none.
std::string findProgram(const std::string& name);

/// The arguments of main() in UTF-8, the name of the program first.
std::vector<std::string> programArguments(int argc, char** argv);
/// The value of an environment variable in UTF-8; empty if it is not set.
std::optional<std::string> environmentVariable(const char* name);
/// What separates folders in environment variables: `:`, or `;` on Windows.
extern const char listSeparator;
/// The folders of an environment variable that lists them, such as PATH.
std::vector<std::string> environmentFolders(const char* name);

/// Number of the running process.
std::int64_t processId();
/// Whether a process of this machine has ended.
bool hasEnded(std::int64_t process);

/// Nanoseconds for which this thread has computed. Windows counts in steps of 16 ms.
std::int64_t threadTime();

/// Keeps libraries from being loaded from the current folder. Call it first in main().
void trustOwnLibraries();
/// Runs another program in place of this one, with the same arguments. Returns only if that fails.
void runInstead(const std::filesystem::path& program);
/// Ends the program without calling destructors or writing buffers.
[[noreturn]] void exitNow(int status);

/// A function of a library that the program has loaded; null if there is none.
void* findFunction(const char* name);

/// Whether the system ends all threads of a program before it destroys the static objects of its libraries,
/// which then may not wait for their threads.
bool endsThreadsFirst();
/// Keeps the library that contains this function in the process until it ends, as its threads run on.
void keepLibraryLoaded();

} // namespace osgTreeWind
