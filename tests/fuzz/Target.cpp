// SPDX-License-Identifier: MIT
#include <tests/fuzz/Readers.h>

#include <cstdint>
#include <cstdio>
#include <cstring>

/// Entry point that libFuzzer calls. The environment variable FUZZ_READER names the reader.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const osgTreeWind::FuzzReader& reader = []() -> const osgTreeWind::FuzzReader& {
        const char* const name = std::getenv("FUZZ_READER");
        for (const osgTreeWind::FuzzReader& each : osgTreeWind::fuzzReaders())
            if (name && std::strcmp(each.name, name) == 0)
                return each;
        std::fprintf(stderr, "fuzz: FUZZ_READER names no reader of this program\n");
        std::exit(2);
    }();
    reader.read({reinterpret_cast<const char*>(data), size});
    return 0;
}
