// SPDX-License-Identifier: MIT
#include <tests/fuzz/FuzzForest.h>

#include <osgTreeWind/io/Toml.h>
#include <osgTreeWind/io/TomlEdit.h>

using namespace osgTreeWind;

/// Aborts if an edit changes other values of a document that stays valid.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text = textOf(data, size);
    const Result<toml::table> before = parseToml(text);
    if (!before)
        return 0;
    TomlEdit edit(text);
    edit.set("wind", "speed", "1.5");
    edit.remove("motion", "gain");
    const Result<toml::table> after = parseToml(edit.text());
    if (!after || after.value()["wind"]["speed"].value<double>() != 1.5)
        return 0;
    toml::table old = before.value(), now = after.value();
    for (toml::table* document : {&old, &now}) {
        if (toml::table* wind = (*document)["wind"].as_table())
            wind->erase("speed");
        if (toml::table* motion = (*document)["motion"].as_table())
            motion->erase("gain");
    }
    if (!old.contains("wind"))
        now.erase("wind");
    if (old == old && old != now) // NaN differs from itself
        std::abort();
    return 0;
}
