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
        [](CPLErr severity, CPLErrorNum number, const char* text) { handleError(severity, number, text); },
        this);
}

GdalErrors::~GdalErrors() {
    CPLPopErrorHandler();
}

void GdalErrors::handleError(int severity, int, const char* text) {
    constexpr std::size_t maxWarnings = 3;
    auto& self = *static_cast<GdalErrors*>(CPLGetErrorHandlerUserData());
    std::string line = printable(text ? text : "");
    if (severity >= CE_Failure) {
        if (self._error.empty())
            self._error = std::move(line);
    } else if (severity == CE_Warning && self._warnings.size() < maxWarnings &&
               std::find(self._warnings.begin(), self._warnings.end(), line) == self._warnings.end())
        self._warnings.push_back(std::move(line));
}

void registerGdal() {
    static std::once_flag once;
    std::call_once(once, GDALAllRegister);
}

} // namespace osgTreeWind
