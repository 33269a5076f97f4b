// SPDX-License-Identifier: MIT
// Without libFuzzer: feeds the reader FUZZ_READER the files of the command line and 2,000 changes of them,
// the same each time. An input that breaks the reader is kept in the current folder.
#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

std::string input;

void keepInput(int signal) {
    std::ofstream("fuzz-" + std::string(std::getenv("FUZZ_READER")), std::ios::binary) << input;
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

void feed(const std::string& bytes) {
    input = bytes;
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

/// Changes, repeats, removes and cuts bytes; half of the places are in the first 500 bytes, where headers
/// are.
std::string changed(std::string bytes, std::mt19937& random) {
    constexpr std::string_view usual = "0123456789-.eE <>\"\n,=[]";
    do {
        const std::size_t size = bytes.size() + 1,
                          range = random() % 2 ? size : std::min<std::size_t>(size, 500),
                          at = random() % range, length = random() % 16;
        const unsigned kind = random() % 16;
        if (kind == 0)
            bytes.insert(at, bytes.substr(random() % size, 4 * length));
        else if (kind == 1)
            bytes.erase(at, length);
        else if (kind == 2)
            bytes.resize(at);
        else if (at < bytes.size())
            bytes[at] = static_cast<char>(random() % 4 ? usual[random() % usual.size()] : random());
    } while (random() % 2);
    return bytes;
}

} // namespace

int main(int argc, char** argv) {
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL})
        std::signal(signal, &keepInput);
    std::vector<std::string> seeds;
    for (int i = 1; i < argc; ++i) {
        std::ifstream file(argv[i], std::ios::binary);
        seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
        feed(seeds.back());
    }
    if (seeds.empty())
        seeds.emplace_back(200, '\1');
    std::mt19937 random(1);
    for (int round = 0; round < 2000; ++round)
        feed(changed(seeds[random() % seeds.size()], random));
    std::cout << "2000 changes of " << seeds.size() << " seeds\n";
}
