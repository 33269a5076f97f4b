// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/NumberList.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>

#include <algorithm>

namespace osgTreeWind {

Result<std::vector<double>> readNumberList(std::istream& input, const std::string& file) {
    auto text = readText(input, file);
    if (!text.ok())
        return text.problems();

    const std::string_view all = text.value();
    std::vector<double> numbers;
    std::size_t at = 0;
    while ((at = all.find_first_not_of(" \t\r\n\f,;", at)) != std::string_view::npos) {
        if (all[at] == '#') {
            at = std::min(all.find('\n', at), all.size());
            continue;
        }
        const std::size_t end = std::min(all.find_first_of(" \t\r\n\f,;#", at), all.size());
        const std::string_view word = all.substr(at, end - at);
        const auto number = parseNumber(word);
        if (!number) {
            const TextPlace place = placeInText(all, at);
            return Diagnostic{file, place.line, place.column, "", expectedFound("a finite number", word)};
        }
        numbers.push_back(*number);
        at = end;
    }
    return numbers;
}

} // namespace osgTreeWind
