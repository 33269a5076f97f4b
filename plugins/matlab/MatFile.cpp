// SPDX-License-Identifier: MIT
#include <plugins/matlab/MatFile.h>

#include <osgTreeWind/system/Path.h>

#include <cstdint>
#include <fstream>
#include <limits>

namespace osgTreeWind {

namespace {

void (*failHandler)(const std::string& reason) = nullptr;

/// @param message a char*, or a const char* as in libmatio 1.5.28.
template <typename Text>
void handleLogMessage(int level, Text message) {
    if (level == MATIO_LOG_LEVEL_ERROR || level == (MATIO_LOG_LEVEL_CRITICAL))
        failHandler(message ? message : "out of memory");
}

/// Whether a file of version 5 ends at the end of a variable. libmatio does not detect truncated files.
bool endsAtVariableBoundary(const std::string& path) {
    std::ifstream file(toPath(path), std::ios::binary | std::ios::ate);
    const auto size = static_cast<std::uint64_t>(file.tellg());
    unsigned char order[2] = {}, tag[8];
    file.seekg(126);
    file.read(reinterpret_cast<char*>(order), 2);
    std::uint64_t at = 128;
    while (at < size) {
        file.seekg(static_cast<std::streamoff>(at));
        if (!file.read(reinterpret_cast<char*>(tag), 8))
            return false;
        std::uint64_t length = 0;
        for (int i = 0; i < 4; ++i)
            length = length << 8 | tag[order[0] == 'I' ? 7 - i : 4 + i];
        at += 8 + length;
    }
    return at == size;
}

template <typename T>
std::vector<double> toDoubles(const matvar_t& variable) {
    const std::size_t count = elementCount(variable);
    if (!variable.data || variable.isComplex || variable.nbytes / sizeof(T) < count)
        return {};
    const T* values = static_cast<const T*>(variable.data);
    return {values, values + count};
}

} // namespace

MatFile::MatFile(const std::string& path, void (*fail)(const std::string& reason)) {
    failHandler = fail;
    Mat_LogInitFunc("osgtreewind-matlab", handleLogMessage);
    _file.reset(Mat_Open(path.c_str(), MAT_ACC_RDONLY));
    if (!_file)
        fail("it cannot be opened");
    if (Mat_GetVersion(_file.get()) == MAT_FT_MAT5 && !endsAtVariableBoundary(path))
        fail("it ends in the middle of a variable");
    while (matvar_t* next = Mat_VarReadNext(_file.get()))
        _variables.emplace_back(next);
}

std::vector<matvar_t*> MatFile::variables() const {
    std::vector<matvar_t*> variables;
    for (const auto& variable : _variables)
        variables.push_back(variable.get());
    return variables;
}

matvar_t* MatFile::variable(const std::string& name) const {
    for (const auto& variable : _variables)
        if (variable->name && variable->name == name)
            return variable.get();
    return nullptr;
}

std::size_t elementCount(const matvar_t& variable) {
    std::size_t count = variable.rank > 0 ? 1 : 0;
    for (int i = 0; i < variable.rank; ++i) {
        if (variable.dims[i] > 0 && count > std::numeric_limits<std::size_t>::max() / variable.dims[i])
            return 0;
        count *= variable.dims[i];
    }
    return count;
}

std::vector<double> numbers(const matvar_t& variable) {
    switch (variable.class_type) {
    case MAT_C_DOUBLE:
        return toDoubles<double>(variable);
    case MAT_C_SINGLE:
        return toDoubles<float>(variable);
    case MAT_C_INT8:
        return toDoubles<std::int8_t>(variable);
    case MAT_C_UINT8:
        return toDoubles<std::uint8_t>(variable);
    case MAT_C_INT16:
        return toDoubles<std::int16_t>(variable);
    case MAT_C_UINT16:
        return toDoubles<std::uint16_t>(variable);
    case MAT_C_INT32:
        return toDoubles<std::int32_t>(variable);
    case MAT_C_UINT32:
        return toDoubles<std::uint32_t>(variable);
    case MAT_C_INT64:
        return toDoubles<std::int64_t>(variable);
    case MAT_C_UINT64:
        return toDoubles<std::uint64_t>(variable);
    default:
        return {};
    }
}

} // namespace osgTreeWind
