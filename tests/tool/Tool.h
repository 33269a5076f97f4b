// SPDX-License-Identifier: MIT
#pragma once

#include <tests/Folders.h>
#include <tests/io/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <sys/wait.h>
#include <vector>

/// Result of a program.
struct Outcome {
    int exitCode = -1; ///< 128 + signal number if it was killed by a signal.
    std::string out, err;
};

inline std::string contentOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline std::string quoted(const std::string& word) {
    std::string text = "'";
    for (const char c : word)
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

/// Runs a shell command in a folder.
inline Outcome runShell(const std::string& command, const std::string& folder = ".") {
    const TemporaryFolder streams;
    const std::string out = streams.path() + "/out", err = streams.path() + "/err";
    const int status =
        std::system(("cd " + quoted(folder) + " && { " + command + "; } >" + out + " 2>" + err).c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contentOf(out), contentOf(err)};
}

/// Runs osgtreewind with these arguments in a folder. @param environment variables to set, such as "A=1 B=2
/// ".
inline Outcome runTool(const std::vector<std::string>& words, const std::string& folder = ".",
                       const std::string& environment = "") {
    std::string command = environment + OSGTREEWIND_TOOL;
    for (const std::string& word : words)
        command += ' ' + quoted(word);
    return runShell(command, folder);
}

/// Path of a file in examples/.
inline std::string example(const std::string& name) {
    return OSGTREEWIND_SOURCE_DIR "/examples/" + name;
}
