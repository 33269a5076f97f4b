// SPDX-License-Identifier: MIT
#include <tests/fuzz/Fuzz.h>

#include <osgTreeWind/windfiles/NetCdfClassic.h>

#include <sys/mman.h>
#include <unistd.h>

using namespace osgTreeWind;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(viewOf(data, size));
    if (!problemOfNetCdfHeader(bytes).empty())
        return 0;
    const int file = memfd_create("fuzz.nc", 0);
    if (write(file, data, size) == static_cast<ssize_t>(size))
        expectWhole(readNetCdf("/proc/self/fd/" + std::to_string(file)));
    close(file);
    return 0;
}
