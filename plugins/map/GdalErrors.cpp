// SPDX-License-Identifier: MIT
#include <plugins/map/GdalErrors.h>

#include <osgTreeWind/base/MessageText.h>

#include <cpl_error.h>
#include <gdal.h>

#include <algorithm>
#include <mutex>

namespace osgTreeWind {

GdalErrors::GdalErrors() {
    CPLPushErrorHandlerEx(
        [](CPLErr severity, CPLErrorNum, const char* text) {
            static_cast<GdalErrors*>(CPLGetErrorHandlerUserData())->hear(severity, text);
        },
        this);
}

GdalErrors::~GdalErrors() {
    CPLPopErrorHandler();
}

void GdalErrors::hear(int severity, const char* text) {
    constexpr std::size_t mostWarnings = 3;
    std::string line = printable(text ? text : "");
    if (severity >= CE_Failure) {
        if (_error.empty())
            _error = std::move(line);
    } else if (severity == CE_Warning && _warnings.size() < mostWarnings &&
               std::find(_warnings.begin(), _warnings.end(), line) == _warnings.end())
        _warnings.push_back(std::move(line));
}

void registerGdal() {
    static std::once_flag once;
    std::call_once(once, GDALAllRegister);
}

} // namespace osgTreeWind
