// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <string>

/// Whether a text has this part.
inline testing::AssertionResult hasPart(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos
               ? testing::AssertionSuccess()
               : testing::AssertionFailure() << "\"" << part << "\" is not part of \"" << text << "\"";
}

/// Whether the text of a problem has exactly this place, "file:line:column: key", and a message with this
/// part.
inline testing::AssertionResult isProblem(const std::string& text, const std::string& place,
                                          const std::string& part) {
    if (text.rfind(place + ": ", 0) != 0)
        return testing::AssertionFailure() << "\"" << text << "\" is not at \"" << place << "\"";
    return hasPart(text.substr(place.size() + 2), part);
}
