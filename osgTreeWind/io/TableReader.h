// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Range.h>
#include <osgTreeWind/io/ReadLog.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace toml {
inline namespace v3 {
class node;
class table;
} // namespace v3
} // namespace toml

namespace osgTreeWind {

/// Reads the keys of one TOML table. Every problem (missing, wrong type, out of range, unknown) goes to the
/// log with dotted key, line and column; the field it was meant for then keeps its value. Not thread-safe.
class TableReader {
public:
    using Section = std::function<void(TableReader&)>;

    /// Parses `text` and hands its root table to `root`. What `root` did not ask for is reported as unknown.
    static void readDocument(const std::string& text, ReadLog& log, const Section& root);

    bool has(const std::string& key) const;
    bool hasArray(const std::string& key) const;
    bool says(const std::string& key, const std::string& text) const;

    /// Reads a value if the key is there. True when `field` was set.
    bool read(const std::string& key, bool& field);
    bool read(const std::string& key, int& field, const Range& range = {});
    bool read(const std::string& key, std::uint32_t& field); ///< Any 32-bit number.
    bool read(const std::string& key, float& field, const Range& range = {});
    bool read(const std::string& key, double& field, const Range& range = {});
    bool read(const std::string& key, std::string& field); ///< Not empty.
    bool readScalar(const std::string& key,
                    std::string& field); ///< A text, a number, a date or a date and time; as text.
    bool read(const std::string& key, glm::vec3& field, const Range& range = {});           ///< Array of 3.
    bool read(const std::string& key, std::vector<double>& field, const Range& range = {}); ///< Array.
    bool read(const std::string& key, std::vector<std::string>& field); ///< Array, none of them empty.

    /// Reads an array of `least` to `most` numbers.
    bool readNumbers(const std::string& key, std::vector<double>& field, std::size_t least, std::size_t most,
                     const Range& range = {});

    /// Reads an array of arrays of `width` numbers.
    bool readRows(const std::string& key, std::vector<std::vector<double>>& field, std::size_t width,
                  const Range& range = {});

    /// Reads an angle given in degrees. @param range in degrees.
    bool readDegrees(const std::string& key, float& radians, const Range& range);

    /// Reads one of a few words.
    template <typename T>
    bool readChoice(const std::string& key, T& field, const std::vector<std::pair<std::string, T>>& choices) {
        std::vector<std::string> words;
        for (const auto& choice : choices)
            words.push_back(choice.first);
        const std::size_t index = readWord(key, words);
        if (index == words.size())
            return false;
        field = choices[index].second;
        return true;
    }

    /// read(), and a problem when the key is not there.
    template <typename... Arguments>
    bool require(const std::string& key, Arguments&&... arguments) {
        return read(key, std::forward<Arguments>(arguments)...) || missing(key);
    }
    /// Reports the key unless it is there. Always false.
    bool missing(const std::string& key);

    /// Reads a table with `section`, if it is there.
    void table(const std::string& key, const Section& section);
    /// Reads every table of `[[key]]` with `section`; a single `[key]` counts as one.
    void tables(const std::string& key, const Section& section);

    /// Notes a problem with the value of `key`, or with the table as a whole when `key` is empty.
    void problem(const std::string& key, const std::string& message);
    /// Leaves the remaining keys unchecked: after a problem that makes their meaning unknown.
    void ignoreRest() { _ignoreRest = true; }

private:
    TableReader(const toml::table& table, std::string path, ReadLog& log);

    const toml::node* find(const std::string& key);
    std::string dotted(const std::string& key) const;
    void problemAt(const toml::node& node, const std::string& key, const std::string& message);
    /// Reads a value that is of a type of TOML's and fits.
    template <typename Given, typename T, typename Fits>
    bool readExact(const std::string& key, T& field, const std::string& expected, Fits fits);
    bool readNumber(const toml::node& node, const std::string& key, double& field, const Range& range);
    bool readArray(const toml::node& node, const std::string& key, std::vector<double>& field,
                   std::size_t least, std::size_t most, const Range& range);
    std::size_t readWord(const std::string& key, const std::vector<std::string>& words);
    void readSection(const toml::node& node, const std::string& key, const Section& section);
    void reportUnknown();

    const toml::table& _table;
    std::string _path; ///< Dotted, empty for the root.
    ReadLog& _log;
    std::set<std::string> _asked;
    bool _ignoreRest = false;
};

} // namespace osgTreeWind
