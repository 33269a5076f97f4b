// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/TextureFetches.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace {

/// Lines that the preprocessor leaves, without comments.
std::string preprocessed(const std::string& glsl) {
    static const std::regex directive(R"(\s*#\s*(\w+)\s*(\w*).*)");
    enum Side { Waiting, Shown, Over };
    std::vector<Side> sides;
    std::set<std::string> defined;
    std::istringstream lines(std::regex_replace(glsl, std::regex(R"(\\\n)"), " "));
    std::string kept;
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
        line.erase(std::min(line.find("//"), line.size()));
        const bool isShown = std::count(sides.begin(), sides.end(), Shown) == std::ptrdiff_t(sides.size());
        if (!std::regex_match(line, match, directive)) {
            kept += isShown ? line + '\n' : "";
        } else if (match[1] == "define" && isShown) {
            defined.insert(match[2]);
        } else if (match[1] == "if" || match[1] == "ifdef" || match[1] == "ifndef") {
            const bool isTrue = match[1] == "if" || defined.count(match[2]) == (match[1] == "ifdef");
            sides.push_back(isTrue ? Shown : Waiting);
        } else if (!sides.empty() && (match[1] == "else" || match[1] == "elif")) {
            sides.back() = sides.back() == Waiting ? Shown : Over;
        } else if (!sides.empty() && match[1] == "endif") {
            sides.pop_back();
        }
    }
    return kept;
}

} // namespace

int textureFetches(const std::string& glsl) {
    static const std::regex token(R"(\w+|[^\s\w])"), fetch("texelFetch.*|texture(?!Size|Query).*");
    std::map<std::string, int> fetches, constants; // of functions, which precede their callers; of names
    std::string function, last, before;
    std::vector<int> rounds = {1}; // of each open brace
    int parentheses = 0, nextRounds = 1;
    bool isLoop = false;
    const std::string text = preprocessed(glsl);
    for (std::sregex_token_iterator i(text.begin(), text.end(), token), end; i != end; ++i) {
        const std::string word = *i;
        if (word == "{") {
            rounds.push_back(rounds.back() * std::exchange(nextRounds, 1));
        } else if (word == "}" && rounds.size() > 1) {
            rounds.pop_back();
        } else if (word == "(") {
            if (rounds.size() == 1 && parentheses == 0)
                fetches[function = last] = 0;
            else if (fetches.count(last) || std::regex_match(last, fetch))
                fetches[function] += rounds.back() * nextRounds * (fetches.count(last) ? fetches[last] : 1);
            isLoop = isLoop || last == "for";
            ++parentheses;
        } else if (word == ")") {
            isLoop = --parentheses > 0 && isLoop;
        } else if (word == ";" && parentheses == 0) {
            nextRounds = 1;
        } else if (isLoop && last == "<") {
            nextRounds *= std::max(1, constants.count(word) ? constants[word] : std::atoi(word.c_str()));
        } else if (last == "=" && rounds.size() == 1) {
            constants[before] = std::atoi(word.c_str());
        }
        before = std::exchange(last, word);
    }
    return fetches["main"];
}
