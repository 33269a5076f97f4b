// SPDX-License-Identifier: MIT
#pragma once

#include <tests/Folders.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

inline std::string pageOf(const std::string& name) {
    std::ifstream file(OSGTREEWIND_SOURCE_DIR "/docs/" + name);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// All text in backquotes.
inline std::vector<std::string> quotedWords(const std::string& text) {
    std::vector<std::string> words;
    for (std::size_t at = text.find('`'); at != std::string::npos; at = text.find('`', at + 1)) {
        const std::size_t end = text.find('`', at + 1);
        if (end == std::string::npos)
            break;
        words.push_back(text.substr(at + 1, end - at - 1));
        at = end;
    }
    return words;
}

/// Fields in the first column of a table, each with the quoted words in the rest of its row. A name without a
/// dot belongs to the object of the field before it in the same row: `a.b`, `c` means `a.b` and `a.c`.
using DocumentedFields = std::map<std::string, std::set<std::string>>;

/// The fields of the first table at or below a line that starts with `heading`.
inline DocumentedFields documentedFields(const std::string& page, const std::string& heading) {
    DocumentedFields fields;
    std::size_t at = page.find("\n" + heading);
    EXPECT_NE(at, std::string::npos) << heading;
    at = page.find("\n| --- |", at);
    std::istringstream lines(page.substr(page.find('\n', at + 1) + 1));
    for (std::string line; std::getline(lines, line) && line.rfind("| ", 0) == 0;) {
        const std::size_t bar = line.find(" | ");
        const std::vector<std::string> said = quotedWords(line.substr(bar));
        std::string beside;
        for (std::string name : quotedWords(line.substr(0, bar))) {
            if (name.size() > 2 && name.compare(name.size() - 2, 2, "[]") == 0)
                name.resize(name.size() - 2);
            if (name.find('.') == std::string::npos)
                name.insert(0, beside);
            beside = name.substr(0, name.rfind('.') == std::string::npos ? 0 : name.rfind('.') + 1);
            fields[name].insert(said.begin(), said.end());
        }
    }
    EXPECT_FALSE(fields.empty()) << heading;
    return fields;
}

/// Adds the path of every field that holds a value, in the notation of the pages.
inline void addFields(const nlohmann::ordered_json& json, const std::string& path,
                      std::set<std::string>& fields) {
    if (json.is_object())
        for (const auto& [key, value] : json.items())
            addFields(value, path.empty() ? key : path + '.' + key, fields);
    else if (json.is_array() && !json.empty() && json.front().is_object())
        for (const auto& value : json)
            addFields(value, path + "[]", fields);
    else
        fields.insert(path);
}

/// Whether a table documents a field: by its path, or in the row of an object that holds it. That row may
/// quote the name of the field, or another object with the same fields.
inline bool isDocumented(const DocumentedFields& table, const std::string& path) {
    if (table.count(path) > 0)
        return true;
    for (std::size_t dot = path.rfind('.'); dot != std::string::npos && dot > 0;
         dot = path.rfind('.', dot - 1)) {
        std::string holder = path.substr(0, dot);
        if (holder.compare(holder.size() - 2, 2, "[]") == 0)
            holder.resize(holder.size() - 2);
        const auto row = table.find(holder);
        if (row == table.end())
            continue;
        if (row->second.count(path.substr(path.rfind('.') + 1)) > 0)
            return true;
        for (const std::string& like : row->second)
            if (like != holder && table.count(like) > 0 && isDocumented(table, like + path.substr(dot)))
                return true;
    }
    return false;
}
