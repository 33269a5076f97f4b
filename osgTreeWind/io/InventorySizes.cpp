// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/InventorySizes.h>

#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/io/InventoryPlaces.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

/// "trunk diameter of 3".
std::string countText(std::string_view key, std::size_t count) {
    std::string name(key);
    std::replace(name.begin(), name.end(), '_', ' ');
    return name + " of " + std::to_string(count);
}

constexpr double maxRecordShare = 1.5; // related species and new records

bool isPossible(double metres, float record) {
    return !(record > 0.0f) || metres <= maxRecordShare * static_cast<double>(record);
}

std::string recordText(const MeasureColumn& measure, float record) {
    return "expected at most " + numberText(maxRecordShare * static_cast<double>(record)) +
           " metres, 1.5 times species." + (std::string(measure.key) == "height" ? "height" : "crown") +
           ".largest";
}

} // namespace

bool InventorySizes::isMissingMark(double number) const {
    return number == 0.0 || isMissing(number) || std::count(missing.begin(), missing.end(), number) > 0;
}

float InventorySizes::checked(const MeasureColumn& measure, const Result<double>& metres) {
    Column& column = _columns[measure.key];
    if (metres) {
        ++column.used;
        return static_cast<float>(metres.value());
    }
    if (column.impossible.rows++ == 0)
        column.impossible.first = metres.problems().front();
    return 0.0f;
}

InventorySize InventorySizes::read(const TreeRows& row, const MeasureColumn& measure, float record) {
    if (!measure.column || !row.has(*measure.column))
        return {};
    std::optional<double> number = row.number(*measure.column);
    SizeText words;
    if (!number) {
        const std::optional<SizeText> read = readWords(row, measure);
        if (!read)
            return {};
        words = *read;
        number = words.value;
    } else if (isMissingMark(*number)) {
        ++_columns[measure.key].marked;
        return {};
    }
    MeasureColumn used = measure;
    used.unit = words.isInMetres ? 1.0 : measure.unit;
    Result<double> metres = readMetres(row, used, number);
    if (metres && !isPossible(metres.value(), record))
        metres = row.problem(row.nameOf(*measure.column),
                             recordText(measure, record) + ", found " + inQuotes(row.text(*measure.column)));
    const float size = checked(measure, metres);
    const bool isEstimate = words.isEstimate && size > 0.0f;
    _columns[measure.key].estimates += isEstimate ? 1 : 0;
    return {size, isEstimate};
}

std::optional<SizeText> InventorySizes::readWords(const TreeRows& row, const MeasureColumn& measure) {
    const std::string text = row.text(*measure.column);
    Column& column = _columns[measure.key];
    const auto size = parseSize(text, measure.kind, decimalComma == false);
    if (isMissing(text) || (size && isMissingMark(size->value))) {
        ++column.marked;
        return std::nullopt;
    }
    const auto add = [&](Count& count, const std::string& message) {
        if (count.rows++ == 0)
            count.first = row.problem(row.nameOf(*measure.column), message);
    };
    if (!size) {
        add(column.unread, expectedFound("a size, such as 18, 18 m, 9-12 or >18", text));
        return std::nullopt;
    }
    add(column.words,
        inQuotes(text) + " as " +
            numberText(std::round(1e4 * size->value * (size->isInMetres ? 1.0 : measure.unit)) / 1e4) + " m");
    column.withUnit += size->isInMetres ? 1 : 0;
    column.unit = measure.unit;
    if (measure.kind == SizeKind::Trunk && !decimalComma && text.find(',') != std::string::npos) {
        const auto separated = parseSize(text, measure.kind, true);
        if (separated && separated->value != size->value && !commaSeparatesNumbers(text))
            add(column.commas, expectedFound("either a decimal comma or two stems", text));
        column.areSeparators |= separated && separated->value == size->value;
        column.areDecimal |= commaSeparatesNumbers(text) == false;
    }
    return size;
}

float InventorySizes::readGeometry(const TreeRows& row, const MeasureColumn& measure, const char* what,
                                   double metres, float record) {
    Result<double> checkedMetres = metres;
    if (!measure.range.contains(metres))
        checkedMetres = row.problem("", std::string("expected ") + what + ' ' + measure.range.text() +
                                            " metres, found " + numberText(metres));
    else if (!isPossible(metres, record))
        checkedMetres = row.problem("", recordText(measure, record) + ", found " + what + " of " +
                                            numberText(metres) + " m");
    return checked(measure, checkedMetres);
}

Diagnostics InventorySizes::problems() const {
    constexpr std::size_t minCount = 3; // fewer are likely to be typing errors
    Diagnostics problems;
    const auto add = [&](const Count& count, const std::string& advice) {
        problems.push_back(count.first);
        problems.back().message += advice;
    };
    for (const auto& [key, column] : _columns) {
        const std::string name(key);
        const std::size_t failed = column.impossible.rows + column.unread.rows;
        const std::string share = "; the same applies to " + std::to_string(failed) + " of " +
                                  std::to_string(failed + column.used) + " rows: ";
        if (column.commas.rows > 0 && column.areSeparators && !column.areDecimal)
            add(column.commas,
                ": set inventory.decimal = \",\" for decimal commas, or \".\" for commas between "
                "stems");
        if (failed < minCount || failed <= column.used)
            continue;
        if (column.unread.rows > column.impossible.rows)
            add(column.unread, share + "set inventory.columns." + name +
                                   " to an expression that gives numbers, such as CASE " +
                                   inQuotes(column.unread.first.key) +
                                   " WHEN 'low' THEN 5 ELSE 12 END, or leave it out");
        else if (column.impossible.first.key.empty() && key == "height")
            add(column.impossible, share +
                                       "set inventory.z to \"height\" if z is the height of the tree, or to "
                                       "\"top\" if it is that of its top above the zero of the ground");
        else
            add(column.impossible, share + "set their unit with inventory.units." + name +
                                       ", or the numbers that mean \"not measured\" with inventory.missing");
    }
    return problems;
}

std::vector<std::string> InventorySizes::counts(const Count Column::*count, const Diagnostic*& first) const {
    std::vector<std::string> counts;
    for (const auto& [key, column] : _columns) {
        if ((column.*count).rows == 0)
            continue;
        if (counts.empty())
            first = &(column.*count).first;
        counts.push_back(countText(key, (column.*count).rows));
    }
    return counts;
}

std::vector<std::string> InventorySizes::notes() const {
    std::vector<std::string> notes, marked, estimates;
    const Diagnostic* first = nullptr;
    for (const auto& [key, column] : _columns) {
        if (column.marked > 0)
            marked.push_back(countText(key, column.marked));
        if (column.estimates > 0)
            estimates.push_back(countText(key, column.estimates));
        if (column.withUnit > 0 && column.unit != 1.0)
            notes.push_back("units in cells count rather than inventory.units: " +
                            countText(key, column.withUnit) + " rows");
    }
    const auto add = [&](const char* what, const Count Column::*count) {
        if (const auto texts = counts(count, first); !texts.empty())
            notes.push_back(what + joined(texts) + " rows, the first: " + first->text());
    };
    add("sizes in words are read: ", &Column::words);
    if (!estimates.empty())
        notes.push_back("classes, bounds and approximate sizes count as estimates: " + joined(estimates) +
                        " rows");
    add("commas are read as decimal (decimal = \".\" reads several stems): ", &Column::commas);
    if (!marked.empty())
        notes.push_back("0 and markers such as -99 count as not measured: " + joined(marked) + " rows");
    add("sizes that cannot be read count as not measured: ", &Column::unread);
    add("impossible sizes count as not measured: ", &Column::impossible);
    return notes;
}

} // namespace osgTreeWind
