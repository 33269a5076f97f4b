// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace osgTreeWind {

/// Edits keys in the text of a TOML document and preserves everything else: comments, order, spaces. An edit
/// that is not possible, such as adding a key to an inline table, is ignored; read the text again to check.
class TomlEdit {
public:
    explicit TomlEdit(std::string text) : _text(std::move(text)) {}

    /// Sets a key to a TOML value. A new key is appended to its table, and a new table to the document.
    /// @param table "wind"; empty: the root table.
    void set(const std::string& table, const std::string& key, const std::string& value);
    /// Removes the lines of a key.
    void remove(const std::string& table, const std::string& key);
    /// Replaces all tables of a name, including nested ones, by other lines. Without such tables, inserts the
    /// lines after the parent table. @param table "wind", "wind.source".
    void replaceTables(const std::string& table, const std::string& lines);

    const std::string& text() const { return _text; }

private:
    void append(const std::string& lines);

    std::string _text;
};

} // namespace osgTreeWind
