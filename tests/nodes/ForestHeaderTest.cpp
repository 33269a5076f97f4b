// SPDX-License-Identifier: MIT
// The number of headers that a host includes with Forest.h.
#include <tests/Folders.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <string>

namespace {

bool isOurs(const std::string& header) {
    return header.rfind("osgTreeWind/", 0) == 0;
}

/// Adds the headers of osgTreeWind and OSG that a header of osgTreeWind includes, directly or through other
/// headers of osgTreeWind.
void addIncluded(const std::string& header, std::set<std::string>& all) {
    const std::string start = "#include <osg";
    std::ifstream file(OSGTREEWIND_SOURCE_DIR "/" + header);
    EXPECT_TRUE(file) << header;
    for (std::string line; std::getline(file, line);)
        if (line.rfind(start, 0) == 0) {
            const std::string name = line.substr(start.size() - 3, line.find('>') - start.size() + 3);
            if (all.insert(name).second && isOurs(name))
                addIncluded(name, all);
        }
}

} // namespace

TEST(ForestHeaderTest, IncludesFewHeaders) {
    std::set<std::string> all;
    addIncluded("osgTreeWind/nodes/Forest.h", all);
    const auto ours = std::count_if(all.begin(), all.end(), isOurs);
    const auto osg = static_cast<std::ptrdiff_t>(all.size()) - ours;
    EXPECT_GT(ours, 1) << "none was found";
    EXPECT_LE(ours, 14);
    EXPECT_GT(osg, 0) << "none was found";
    EXPECT_LE(osg, 10) << "also indirectly";
}
