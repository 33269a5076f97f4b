// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindFormats.h>

#include <osgTreeWind/base/DateText.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Range.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/wind/WindDirection.h>
#include <osgTreeWind/wind/WindLimits.h>

#include <glm/trigonometric.hpp>

#include <pugixml.hpp>

#include <limits>

namespace osgTreeWind {

namespace {

constexpr double anyNumber = std::numeric_limits<double>::max();

/// Reads the timeSeries elements and collects all problems; success if `problems` is empty.
class SensorReader {
public:
    SensorReader(std::string_view text, const std::string& file) : _text(text), _file(file) {}

    Diagnostics problems;

    /// Time of the first record, seconds since 1970.
    double start() const { return _start; }

    WindSeries read() {
        pugi::xml_document document;
        const pugi::xml_parse_result parsed = document.load_buffer(
            _text.data(), _text.size(), pugi::parse_default | pugi::parse_fragment, pugi::encoding_utf8);
        if (!parsed) {
            report(parsed.offset, {}, std::string("broken XML: ") + parsed.description());
            return {};
        }
        WindSeries series;
        pugi::xpath_node_set records = document.select_nodes("//timeSeries");
        records.sort();
        for (const pugi::xpath_node& found : records) {
            if (problems.size() >= maxRecordProblems)
                break;
            readRecord(found.node(), series);
        }
        if (series.times.empty() && problems.empty())
            report(0, {}, "expected at least one timeSeries element");
        return series;
    }

private:
    void report(std::ptrdiff_t offset, const std::string& key, std::string message) {
        const TextPosition place = positionInText(_text, static_cast<std::size_t>(offset));
        problems.push_back({_file, place.line, place.column, key, std::move(message)});
    }

    /// Reads the number in an element of a record. @param absent value of an optional element that is
    /// missing; none if the element is required.
    double number(pugi::xml_node record, const char* name, const Range& range, const char* what,
                  std::optional<double> absent = std::nullopt) {
        const pugi::xml_node element = record.child(name);
        if (!element) {
            if (!absent)
                report(record.offset_debug(), name,
                       name == std::string("timeEpoch") ? "expected this element or timeStamp in timeSeries"
                                                        : "expected this element in timeSeries");
            return absent.value_or(0.0);
        }
        if (const pugi::xml_node second = element.next_sibling(name))
            report(second.offset_debug(), name, "expected this element once in timeSeries");

        const bool onlyText = element.first_child() == element.last_child();
        const std::optional<double> value = parseNumber(element.child_value());
        if (onlyText && value && range.contains(*value))
            return *value;
        report(element.offset_debug(), name, expectedFound(what, element.child_value()));
        return 0.0;
    }

    /// Parses a date and time to seconds since 1970.
    double timeStamp(pugi::xml_node element) {
        const std::string text = element.child_value();
        const auto seconds = parseDate(trimmed(text));
        if (!seconds)
            report(element.offset_debug(), "timeStamp",
                   expectedFound("a date and time such as 2020-01-01T12:00:00", text));
        return seconds.value_or(0.0);
    }

    void readRecord(pugi::xml_node record, WindSeries& series) {
        const std::size_t before = problems.size();
        const bool isText = !record.child("timeEpoch") && record.child("timeStamp");
        const char* const timeKey = isText ? "timeStamp" : "timeEpoch";
        const double time = isText ? timeStamp(record.child(timeKey))
                                   : number(record, timeKey, within(-anyNumber, anyNumber), "seconds");
        const LogProfile profile{number(record, "height", within(1e-6, 1e6), "metres above 0"),
                                 number(record, "siteZ0", within(1e-6, 1e6), "metres above 0")};
        const double speed =
            number(record, "speed", within(0.0, maxMeasuredSpeed), "a wind speed of 0 to 200 m/s");
        const double direction =
            number(record, "direction", within(-maxDirection, maxDirection), "degrees of -360 to 360");
        number(record, "boundaryLayerFlag", within(1.0, 1.0), "1 (logarithmic profile)", 1.0);
        number(record, "reciprocal", within(0.0, 0.0), "0 (neutral stability)", 0.0);
        if (problems.size() != before)
            return;

        if (!profile.valid())
            return report(record.offset_debug(), "siteZ0", "expected a roughness length below the height");
        if (!series.profile) {
            series.profile = profile;
            _start = time;
        } else if (profile.height != series.profile->height ||
                   profile.roughness != series.profile->roughness) {
            return report(record.offset_debug(), "height",
                          "expected the height and siteZ0 of the first record, " +
                              numberText(series.profile->height) + " and " +
                              numberText(series.profile->roughness));
        } else if (time - _start <= series.times.back()) {
            return report(record.child(timeKey).offset_debug(), timeKey,
                          expectedFound("a later time than in the record before", numberText(time)));
        }
        series.times.push_back(time - _start);
        series.velocities.push_back(windVelocity({speed, glm::radians(direction)}, DirectionSense::From));
    }

    std::string_view _text;
    const std::string& _file;
    double _start = 0.0;
};

} // namespace

Result<WindContent> readQesSensor(std::string_view bytes, const std::string& file) {
    const Result<std::string_view> text = plainText(bytes, file);
    if (!text)
        return text.problems();
    SensorReader reader(text.value(), file);
    WindSeries series = reader.read();
    if (!reader.problems.empty())
        return reader.problems;
    WindContent content;
    content.summary.format = "QES-Winds sensor";
    content.summary.unit = "m/s";
    content.summary.start = isoTimeText(reader.start());
    content.summary.direction = "from, degrees clockwise from north";
    content.summary.notes = {"measured " + numberText(series.profile->height) +
                             " m above ground of roughness length " + numberText(series.profile->roughness) +
                             " m; a logarithmic profile at other heights"};
    content.data = std::move(series);
    return content;
}

} // namespace osgTreeWind
