// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Range.h>
#include <osgTreeWind/base/Unicode.h>
#include <osgTreeWind/base/UnitsOfMeasure.h>
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

/// Reads the keys of one TOML table. Every problem (missing, wrong type, out of range, unknown key) goes to
/// the log with dotted key, line and column, and the field keeps its value. Not thread-safe.
class TableReader {
public:
    using Section = std::function<void(TableReader&)>;

    /// Parses `text` and reads its root table with `root`. Reports keys that `root` did not read.
    static void readDocument(const std::string& text, ReadLog& log, const Section& root);

    bool has(const std::string& key) const;
    bool hasArray(const std::string& key) const;
    /// Whether the value of the key is this text.
    bool hasText(const std::string& key, const std::string& text) const;

    /// All texts in the table of the key, and in its arrays. The keys do not count as read.
    std::vector<std::string> texts(const std::string& key) const;

    /// Reads a value if the key is present. @return whether `field` was set.
    bool read(const std::string& key, bool& field);
    bool read(const std::string& key, int& field, const Range& range = {});
    bool read(const std::string& key, std::uint32_t& field); ///< Any 32-bit number.
    bool read(const std::string& key, float& field, const Range& range = {});
    bool read(const std::string& key, double& field, const Range& range = {});
    bool read(const std::string& key, std::string& field); ///< Not empty.
    /// Reads a text, a number, a date or a date and time; as text.
    bool readScalar(const std::string& key, std::string& field);
    bool read(const std::string& key, glm::vec3& field, const Range& range = {});           ///< Array of 3.
    bool read(const std::string& key, std::vector<double>& field, const Range& range = {}); ///< Array.
    bool read(const std::string& key, std::vector<std::string>& field); ///< Array of non-empty texts.

    /// Reads an array of `minCount` to `maxCount` numbers.
    bool readNumbers(const std::string& key, std::vector<double>& field, std::size_t minCount,
                     std::size_t maxCount, const Range& range = {});

    /// Reads an array of arrays of `width` numbers.
    bool readRows(const std::string& key, std::vector<std::vector<double>>& field, std::size_t width,
                  const Range& range = {});

    /// Reads an angle given in degrees. @param range in degrees.
    bool readDegrees(const std::string& key, float& radians, const Range& range);

    /// Reads one of the given words.
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

    /// Reads the name of a unit. @return its size (Dimension); empty if it is missing or, with a problem,
    /// unknown.
    std::optional<double> readUnit(const std::string& key, Dimension dimension, std::string* name = nullptr);

    /// Reads a value; reports a problem if the key is missing.
    template <typename... Arguments>
    bool require(const std::string& key, Arguments&&... arguments) {
        return read(key, std::forward<Arguments>(arguments)...) || reportMissing(key);
    }
    /// Reports a missing key, unless it is present. @return false.
    bool reportMissing(const std::string& key);

    /// Reads a table with `section`, if it is present.
    void table(const std::string& key, const Section& section);
    /// Reads every table of `[[key]]` with `section`; also accepts a single `[key]`.
    void tables(const std::string& key, const Section& section);

    /// Reports a problem with the value of `key`, or with the whole table if `key` is empty.
    void problem(const std::string& key, const std::string& message);
    /// Reports a problem with another file.
    void report(const Diagnostic& problem) { _log.add(problem); }
    /// Adds a note on the forest.
    void note(std::string text) { _log.notes.push_back(asUtf8(std::move(text))); }
    /// Whether no problem of the document has been reported so far.
    bool isDocumentValid() const { return _log.problems.empty(); }
    /// Does not report unknown keys; for use after a problem that makes the remaining keys meaningless.
    void ignoreRest() { _ignoreRest = true; }

private:
    TableReader(const toml::table& table, std::string path, ReadLog& log);

    const toml::node* find(const std::string& key);
    std::string dotted(const std::string& key) const;
    void problemAt(const toml::node& node, const std::string& key, const std::string& message);
    /// Reads a value of a TOML type if `isValid` accepts it.
    template <typename TomlType, typename T, typename IsValid>
    bool readExact(const std::string& key, T& field, const std::string& expected, IsValid isValid);
    bool readNumber(const toml::node& node, const std::string& key, double& field, const Range& range);
    bool readArray(const toml::node& node, const std::string& key, std::vector<double>& field,
                   std::size_t minCount, std::size_t maxCount, const Range& range);
    std::size_t readWord(const std::string& key, const std::vector<std::string>& words);
    void readSection(const toml::node& node, const std::string& key, const Section& section);
    void reportUnknown();

    const toml::table& _table;
    std::string _path; ///< Dotted, empty for the root.
    ReadLog& _log;
    std::set<std::string> _requestedKeys;
    bool _ignoreRest = false;
};

} // namespace osgTreeWind
