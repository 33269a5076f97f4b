// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Digest.h>

#include <gtest/gtest.h>

#include <set>

namespace osgTreeWind {
namespace {

std::string digestOf(const std::string& text) {
    Digest digest;
    digest.add(text.data(), text.size());
    return digest.bytes();
}

} // namespace

TEST(Digest, IsTheSameForTheSameBytes) {
    EXPECT_EQ(digestOf("some text").size(), 16u);
    EXPECT_EQ(digestOf("some text"), digestOf("some text"));
}

TEST(Digest, ChangesWithEachBitAndSize) {
    std::set<std::string> all;
    std::size_t count = 0;
    for (std::size_t size = 0; size < 40; ++size) {
        const std::string text(size, '\0');
        all.insert(digestOf(text));
        ++count;
        for (std::size_t bit = 0; bit < 8 * size; ++bit) {
            std::string changed = text;
            changed[bit / 8] = static_cast<char>(1 << bit % 8);
            all.insert(digestOf(changed));
            ++count;
        }
    }
    EXPECT_EQ(all.size(), count);
    std::set<std::string> halves;
    for (const std::string& digest : all) {
        halves.insert(digest.substr(0, 8));
        halves.insert(digest.substr(8));
    }
    EXPECT_EQ(halves.size(), 2 * count) << "both halves are hashes";
}

TEST(Digest, DependsOnTheOrder) {
    Digest one, other;
    one.add(1);
    one.add(2);
    other.add(2);
    other.add(1);
    EXPECT_NE(one.bytes(), other.bytes());
}

} // namespace osgTreeWind
