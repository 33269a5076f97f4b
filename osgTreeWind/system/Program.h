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
/// The folder for the caches of the user's programs. Not absolute if the environment names none.
std::filesystem::path cacheFolder();
/// A file of a font whose characters are of equal width; it may be missing.
std::string monospaceFontFile();
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

/// Nanoseconds for which this thread has computed, and the steps in which the system counts them.
std::int64_t threadTime();
extern const std::int64_t threadTimeStep;

/// Keeps libraries from being loaded from the current folder. Call it first in main().
void trustOwnLibraries();
/// Runs another program in place of this one, with the same arguments. Returns only if that fails.
void runInstead(const std::filesystem::path& program);
/// Ends the program without calling destructors or writing buffers.
[[noreturn]] void exitNow(int status);

/// A function of a library that the program has loaded; null if there is none.
void* findFunction(const char* name);

/// If the system ends all threads of a program before it destroys the static objects of its libraries, keeps
/// the library that contains this function in the process until then. @return whether it does, so that these
/// objects may not wait for their threads.
bool endsThreadsFirst();

} // namespace osgTreeWind
