// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Result.h>

#include <cstdlib>
#include <iostream>

namespace osgTreeWind {

std::string Diagnostic::text() const {
    std::string place = file;
    if (line > 0) {
        place += ':' + std::to_string(line);
        if (column > 0)
            place += ':' + std::to_string(column);
    }
    std::string result;
    if (!place.empty())
        result += place + ": ";
    if (!key.empty())
        result += key + ": ";
    return result + message;
}

void abortWithoutValue(const Diagnostics& problems) {
    std::cerr << "osgTreeWind: the value of a result that has none was taken; ask ok() before value()\n";
    for (const Diagnostic& problem : problems)
        std::cerr << "    " << problem.text() << '\n';
    std::cerr.flush();
    std::abort();
}

} // namespace osgTreeWind
