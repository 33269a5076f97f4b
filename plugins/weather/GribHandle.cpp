// SPDX-License-Identifier: MIT
#include <plugins/weather/GribHandle.h>

#include <array>
#include <limits>

namespace osgTreeWind {

namespace {

codes_context* quietContext() {
    static codes_context* const context = [] {
        codes_context* const made = codes_context_get_default();
        codes_context_set_logging_proc(made, [](const codes_context*, int, const char*) {});
        return made;
    }();
    return context;
}

} // namespace

GribHandle::GribHandle(const std::vector<std::string_view>& parts) : _handle(nullptr, codes_handle_delete) {
    for (const std::string_view part : parts)
        _message += part;
    if (_message.size() > 16 && _message[7] == 2) // its size may be that of a message with several fields
        for (std::size_t octet = 0; octet < 8; ++octet)
            _message[8 + octet] = static_cast<char>(_message.size() >> (8 * (7 - octet)) & 0xff);
    _handle.reset(codes_handle_new_from_message(quietContext(), _message.data(), _message.size()));
}

long GribHandle::integer(const char* key, long otherwise) const {
    long value = 0;
    int error = 0;
    const bool isKnown = codes_get_long(_handle.get(), key, &value) == CODES_SUCCESS &&
                         !codes_is_missing(_handle.get(), key, &error);
    return isKnown ? value : otherwise;
}

double GribHandle::real(const char* key) const {
    double value = 0.0;
    codes_get_double(_handle.get(), key, &value);
    return value;
}

std::string GribHandle::text(const char* key) const {
    std::array<char, 256> value{};
    std::size_t size = value.size() - 1;
    return codes_get_string(_handle.get(), key, value.data(), &size) == CODES_SUCCESS ? value.data() : "";
}

void GribHandle::set(const char* key, const std::string& value) const {
    std::size_t size = value.size();
    codes_set_string(_handle.get(), key, value.c_str(), &size);
}

std::string GribHandle::withZeroValues(std::size_t numbers) const {
    const Owned copy(codes_handle_clone(_handle.get()), codes_handle_delete);
    std::size_t count = 0, length = 0;
    const void* message = nullptr;
    if (!copy || codes_get_size(copy.get(), "values", &count) != CODES_SUCCESS || count != numbers)
        return {};
    const std::vector<double> zeros(count, 0.0);
    if (codes_set_string(copy.get(), "packingType", "grid_simple", &length) != CODES_SUCCESS ||
        codes_set_double_array(copy.get(), "values", zeros.data(), count) != CODES_SUCCESS ||
        codes_get_message(copy.get(), &message, &length) != CODES_SUCCESS)
        return {};
    return {static_cast<const char*>(message), length};
}

std::optional<std::string> GribHandle::readValues(std::vector<double>& numbers) const {
    constexpr double missing = 1e35; // not a valid wind or height
    std::size_t count = 0;
    int error = codes_get_size(_handle.get(), "values", &count);
    if (error == CODES_SUCCESS && count != numbers.size())
        return "expected " + std::to_string(numbers.size()) + " numbers, found " + std::to_string(count);
    if (error == CODES_SUCCESS)
        error = codes_set_double(_handle.get(), "missingValue", missing);
    if (error == CODES_SUCCESS)
        error = codes_get_double_array(_handle.get(), "values", numbers.data(), &count);
    if (error != CODES_SUCCESS)
        return codes_get_error_message(error);
    for (double& number : numbers)
        if (number == missing)
            number = std::numeric_limits<double>::quiet_NaN();
    return {};
}

} // namespace osgTreeWind
