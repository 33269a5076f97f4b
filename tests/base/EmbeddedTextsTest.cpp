// SPDX-License-Identifier: MIT
#include <tests/Folders.h>

#include <osgTreeWind/base/EmbeddedTexts.h>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace osgTreeWind {

TEST(EmbeddedTexts, EqualTheSourceFiles) {
    ASSERT_FALSE(embeddedTexts().empty());
    for (const EmbeddedText& embedded : embeddedTexts()) {
        std::ifstream file(OSGTREEWIND_SOURCE_DIR "/" + embedded.name, std::ios::binary);
        std::ostringstream text;
        text << file.rdbuf();
        EXPECT_EQ(embedded.text, text.str()) << embedded.name;
    }
}

} // namespace osgTreeWind
