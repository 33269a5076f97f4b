// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/ByteOrder.h>
#include <osgTreeWind/windfiles/WindFormats.h>

#include <osgTreeWind/base/Number.h>

#include <cmath>

namespace osgTreeWind {

namespace {

constexpr std::size_t headerSize = 70; // including the length of the description

struct TurbSimHeader {
    std::int16_t id;
    std::int32_t up, across, tower, times, description;
    float dz, dy, dt, hubSpeed, hubHeight, bottom;
    float slope[3], offset[3];
};

TurbSimHeader readHeader(std::string_view bytes) {
    std::size_t at = 0;
    const auto take = [&](auto& field) {
        field = numberAt<std::decay_t<decltype(field)>>(bytes, at, ByteOrder::Little);
        at += sizeof field;
    };
    TurbSimHeader h{};
    take(h.id);
    for (std::int32_t* count : {&h.up, &h.across, &h.tower, &h.times})
        take(*count);
    for (float* value : {&h.dz, &h.dy, &h.dt, &h.hubSpeed, &h.hubHeight, &h.bottom})
        take(*value);
    for (int i = 0; i < 3; ++i) {
        take(h.slope[i]);
        take(h.offset[i]);
    }
    take(h.description);
    return h;
}

/// A problem of the header.
struct Fault {
    std::size_t byte;
    const char* expected; ///< Null if there is none.
};

Fault findFault(const TurbSimHeader& h) {
    const auto outside = [](float value, float low, float high) { return !(value >= low && value <= high); };
    if (h.id != 7 && h.id != 8)
        return {0, "7 or 8, the identifier of a TurbSim file"};
    if (h.up < 1 || h.across < 1 || h.times < 1)
        return {2, "numbers of points and times of at least 1"};
    if (h.tower < 0)
        return {10, "a number of tower points of at least 0"};
    if (outside(h.dz, 1e-6f, 1e6f) || outside(h.dy, 1e-6f, 1e6f) || outside(h.dt, 1e-6f, 1e6f))
        return {18, "spacings in metres and seconds above 0"};
    if (outside(h.hubSpeed, 1e-3f, 200.0f))
        return {30, "a mean wind speed above 0 to 200 m/s"};
    if (outside(h.hubHeight, -1e6f, 1e6f) || outside(h.bottom, -1e6f, 1e6f))
        return {34, "heights in metres"};
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(h.slope[i]) || h.slope[i] == 0.0f || !std::isfinite(h.offset[i]))
            return {42 + 8 * static_cast<std::size_t>(i),
                    "a finite scale that is not 0, and a finite offset"};
    if (h.description < 0 || h.description > 1 << 20)
        return {66, "a length of the description of 0 to 1048576"};
    return {0, nullptr};
}

} // namespace

Result<WindContent> readTurbSim(std::string_view bytes, const std::string& file) {
    const auto problem = [&](std::size_t byte, const std::string& message) {
        return Diagnostic{file, 0, 0, "byte " + std::to_string(byte), message};
    };
    if (bytes.size() < headerSize)
        return problem(bytes.size(), "the file ends within its header of 70 bytes");
    const TurbSimHeader h = readHeader(bytes);
    if (const Fault fault = findFault(h); fault.expected)
        return problem(fault.byte, std::string("expected ") + fault.expected);
    const double perTime = 3.0 * h.across * h.up + 3.0 * h.tower;
    const double expected = headerSize + h.description + 2.0 * perTime * h.times;
    if (static_cast<double>(bytes.size()) != expected)
        return problem(bytes.size(), "expected " + numberText(expected) + " bytes for " +
                                         std::to_string(h.across) + " x " + std::to_string(h.up) +
                                         " points, " + std::to_string(h.tower) + " tower points and " +
                                         std::to_string(h.times) + " times, found " +
                                         std::to_string(bytes.size()));

    GridWind::Grid grid;
    grid.points = {1, h.across, h.up};
    grid.origin = {0.0, -0.5 * (h.across - 1) * static_cast<double>(h.dy), h.bottom};
    grid.cell = {1.0, h.dy, h.dz};
    std::size_t at = headerSize + static_cast<std::size_t>(h.description);
    const std::size_t components = 3 * static_cast<std::size_t>(h.across) * static_cast<std::size_t>(h.up);
    grid.values.reserve(components * static_cast<std::size_t>(h.times));
    for (int t = 0; t < h.times; ++t) {
        grid.times.push_back(t * static_cast<double>(h.dt));
        for (std::size_t i = 0; i < components; ++i, at += 2) {
            const float raw = numberAt<std::int16_t>(bytes, at, ByteOrder::Little);
            grid.values.push_back((raw - h.offset[i % 3]) / h.slope[i % 3]);
        }
        at += 6 * static_cast<std::size_t>(h.tower);
    }
    WindContent content;
    content.summary.format = "TurbSim full field";
    content.summary.unit = "m/s";
    content.summary.direction = "components toward x (downwind), y (left) and z (up)";
    content.summary.notes = {"drifts along x at " + numberText(h.hubSpeed) + " m/s, the mean at hub height " +
                             numberText(h.hubHeight) + " m"};
    if (h.id == 8)
        content.summary.notes.emplace_back("periodic, but clamped to the last time instead of repeated");
    if (h.tower > 0)
        content.summary.notes.push_back(std::to_string(h.tower) +
                                        " tower points below the grid are not used");
    content.data = std::move(grid);
    content.travelSpeed = h.hubSpeed;
    return content;
}

} // namespace osgTreeWind
