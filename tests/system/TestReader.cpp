// SPDX-License-Identifier: MIT
// A reader program for tests: answers, or comes to one of the ends that damaged files can give a reader.
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Wire.h>
#include <osgTreeWind/system/Descriptor.h>
#include <osgTreeWind/system/ProcessLimits.h>
#include <osgTreeWind/system/Program.h>

#include <chrono>
#include <memory>
#include <thread>

using namespace osgTreeWind;

namespace {

/// Allocates and writes memory until there is no more, 16 MiB at a time. @return the bytes.
std::size_t allocateAll() {
    constexpr std::size_t size = std::size_t(1) << 24;
    std::vector<std::unique_ptr<char[]>> blocks;
    try {
        for (;;) {
            blocks.push_back(std::make_unique<char[]>(size));
            for (std::size_t i = 0; i < size; i += 4096)
                blocks.back()[i] = 1;
        }
    } catch (const std::bad_alloc&) {
        return blocks.size() * size;
    }
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> arguments = programArguments(argc, argv);
    const std::string& task = arguments.at(2); // after the file
    const int connection = takeStandardOutput();
    std::puts("libraries print such lines");
    limitMemory(std::size_t(1) << 28);
    if (task == "arguments") {
        Result<std::vector<std::string>> answer(arguments);
        return Wire::send(connection, answer) ? 0 : 1;
    }
    if (task == "memory") {
        Result<std::size_t> answer(allocateAll());
        exitNow(Wire::send(connection, answer) && finishOutput(connection) ? 0 : 1);
    }
    if (task == "time") {
        limitTime(1);
        std::this_thread::sleep_for(std::chrono::seconds(60));
    }
    if (task == "crash")
        *static_cast<volatile int*>(nullptr) = 1;
    if (task == "status")
        exitNow(3);
    char byte = 0; // "echo"
    while (readSome(connection, &byte, 1) == 1)
        if (writeSome(connection, &byte, 1) != 1)
            return 1;
    return 0;
}
