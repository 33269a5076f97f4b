// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace osgTreeWind {

/// Changes keys in the text of a TOML document, and leaves all else as it stands: comments, order, spaces.
/// What it cannot change so (a key that would come into an inline table) is not changed: read the text again.
class TomlEdit {
public:
    explicit TomlEdit(std::string text) : _text(std::move(text)) {}

    /// Gives a key another value, as TOML has it. A key that is not there comes behind the others of its
    /// table, and a table that is not there behind all. @param table "wind"; empty: of the document itself.
    void set(const std::string& table, const std::string& key, const std::string& value);
    /// Takes away the lines that a key is on.
    void remove(const std::string& table, const std::string& key);
    /// Puts other lines in place of the tables of a name and of those within them; where there are none,
    /// behind the table that they are in. @param table "wind", "wind.source".
    void replaceTables(const std::string& table, const std::string& lines);

    const std::string& text() const { return _text; }

private:
    void append(const std::string& lines);

    std::string _text;
};

} // namespace osgTreeWind
