// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Program.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <fstream>

#include <dlfcn.h>
#include <unistd.h>

namespace osgTreeWind {

const char programSuffix[] = "";
const char listSeparator = ':';
const std::int64_t threadTimeStep = 0;

std::filesystem::path programPath() {
    std::error_code ignored;
    return std::filesystem::read_symlink("/proc/self/exe", ignored);
}

std::filesystem::path libraryPath() {
    static const char symbol = 0;
    Dl_info info{};
    dladdr(&symbol, &info);
    const std::filesystem::path object = info.dli_fname ? info.dli_fname : "";
    return object.is_absolute() ? object : programPath(); // argv[0] of a statically linked program
}

std::vector<std::string> programArguments(int argc, char** argv) {
    return std::vector<std::string>(argv, argv + argc);
}

std::optional<std::string> environmentVariable(const char* name) {
    const char* const value = std::getenv(name);
    return value ? std::optional<std::string>(value) : std::nullopt;
}

std::filesystem::path cacheFolder() {
    if (std::filesystem::path caches = environmentVariable("XDG_CACHE_HOME").value_or("");
        caches.is_absolute())
        return caches;
    return std::filesystem::path(environmentVariable("HOME").value_or("")) / ".cache";
}

std::string monospaceFontFile() {
    return "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf";
}

std::int64_t processId() {
    return getpid();
}

bool hasEnded(std::int64_t process) {
    return kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
}

std::int64_t threadTime() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return std::int64_t(1000000000) * now.tv_sec + now.tv_nsec;
}

void trustOwnLibraries() {}

void runInstead(const std::filesystem::path& program) {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    std::vector<std::string> words;
    for (std::string word; std::getline(file, word, '\0');)
        words.push_back(word);
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv(program.c_str(), arguments.data());
}

void exitNow(int status) {
    _exit(status);
}

void* findFunction(const char* name) {
    return dlsym(RTLD_DEFAULT, name);
}

bool endsThreadsFirst() {
    return false;
}

} // namespace osgTreeWind
