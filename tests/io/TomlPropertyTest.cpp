// SPDX-License-Identifier: MIT
// Property tests: TOML values survive writing and reading, and edits preserve everything else.
#include <osgTreeWind/io/Toml.h>
#include <osgTreeWind/io/TomlEdit.h>
#include <osgTreeWind/io/TomlText.h>

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

namespace {

rc::Gen<std::string> text() {
    return rc::gen::container<std::string>(rc::gen::oneOf(
        rc::gen::elementOf(std::string("\"'\\#=[]{}\n\r\t\b\f\x1f\x7f ")), rc::gen::inRange<char>('0', 'z')));
}

/// A document with the tables [wind] and [motion] and a comment on each line.
std::string documentOf(const std::map<std::string, int>& wind, const std::map<std::string, int>& motion) {
    std::string lines = "# a forest\nversion = 1\n";
    for (const auto& [name, table] : {std::pair("wind", &wind), std::pair("motion", &motion)}) {
        lines += std::string("\n[") + name + "] # of it\n";
        for (const auto& [key, value] : *table)
            lines += key + " = " + std::to_string(value) + " # " + key + "\n";
    }
    return lines;
}

} // namespace

RC_GTEST_PROP(TomlProperty, EveryTextReadsBack, ()) {
    const std::string written = *text();
    const Result<toml::table> document = parseToml("a = " + tomlText(written) + "\nb = 1\n");
    RC_ASSERT(document.ok());
    RC_ASSERT(document.value()["a"].value<std::string>() == written);
    RC_ASSERT(document.value()["b"].value<int>() == 1);
}

RC_GTEST_PROP(TomlProperty, EveryFloatReadsBackExactly, (std::uint32_t bits)) {
    float number = 0.0f;
    std::memcpy(&number, &bits, sizeof number);
    RC_PRE(std::isfinite(number));
    const Result<toml::table> document = parseToml("a = " + tomlText(number));
    RC_ASSERT(document.ok());
    RC_ASSERT(static_cast<float>(*document.value()["a"].value<double>()) == number);
}

RC_GTEST_PROP(TomlProperty, EditsKeepOtherLines, ()) {
    const auto keys = rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 8));
    const auto name = [](int key) { return std::string(1, static_cast<char>('a' + key)); };
    std::map<std::string, int> wind, motion;
    for (const int key : *keys)
        wind[name(key)] = motion[name(7 - key)] = *rc::gen::inRange(-9, 99);
    TomlEdit edit(documentOf(wind, motion));
    for (const int key : *keys) {
        const int value = *rc::gen::inRange(-9, 99);
        edit.set("wind", name(key), std::to_string(value));
        wind[name(key)] = value;
    }
    for (const int key : *keys) {
        edit.remove("motion", name(key));
        motion.erase(name(key));
    }
    const Result<toml::table> after = parseToml(edit.text()), wanted = parseToml(documentOf(wind, motion));
    RC_ASSERT(after.ok());
    RC_ASSERT(after.value() == wanted.value());
    RC_ASSERT(edit.text().rfind("# a forest\nversion = 1\n\n[wind] # of it\n", 0) == 0u);
    RC_ASSERT(edit.text().find("\n[motion] # of it\n") != std::string::npos);
}

} // namespace osgTreeWind
