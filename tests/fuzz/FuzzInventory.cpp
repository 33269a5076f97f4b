// SPDX-License-Identifier: MIT
#include <tests/fuzz/FuzzForest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

using namespace osgTreeWind;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto file =
        std::filesystem::temp_directory_path() / ("fuzz" + std::to_string(getpid()) + ".csv");
    std::ofstream(file, std::ios::binary) << textOf(data, size);
    expectForest("version = 1\n[[inventory]]\nfile = \"" + file.string() +
                 "\"\nspecies = \"oak\"\n[inventory.columns]\nx = \"x\"\ny = \"y\"\nid = \"id\"\n"
                 "species = \"species\"\nheight = \"height\"\ntrunk_diameter = \"dbh\"\n"
                 "[inventory.units]\ntrunk_diameter = \"cm\"\n");
    return 0;
}
