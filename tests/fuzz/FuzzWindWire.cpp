// SPDX-License-Identifier: MIT
#include <tests/fuzz/Fuzz.h>

#include <osgTreeWind/base/Wire.h>
#include <osgTreeWind/windfiles/WindContent.h>

#include <sys/mman.h>
#include <unistd.h>

using namespace osgTreeWind;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const int file = memfd_create("fuzz", 0);
    if (write(file, data, size) == static_cast<ssize_t>(size) && lseek(file, 0, SEEK_SET) == 0) {
        const auto content = Wire::receive<WindContent>(file);
        if (content && content->ok())
            (void)GridWind::check(std::get<GridWind::Grid>(content->value().data));
    }
    close(file);
    return 0;
}
