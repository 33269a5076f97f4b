// SPDX-License-Identifier: MIT
#include <tests/fuzz/FuzzForest.h>

#include <osgTreeWind/io/TomlText.h>

#include <filesystem>
#include <fstream>

#include <unistd.h>

using namespace osgTreeWind;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::string table = [] {
        const auto file =
            std::filesystem::temp_directory_path() / ("fuzz" + std::to_string(getpid()) + ".csv");
        std::ofstream(file) << "id,x,y,species,height\n1,2,3,Quercus robur,20\n2,5,9,birch,\n";
        return file.string();
    }();
    expectForest("version = 1\n[[inventory]]\nfile = \"" + table + "\"\nspecies = \"oak\"\nfilter = " +
                 tomlText(textOf(data, size)) + "\n[inventory.columns]\nx = \"x\"\ny = \"y\"\nid = \"id\"\n");
    return 0;
}
