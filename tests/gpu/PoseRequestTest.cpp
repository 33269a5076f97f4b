// SPDX-License-Identifier: MIT
// The shaders read a PoseRequest as its C++ struct lays it out.
#include <osgTreeWind/gpu/PosePage.h>

#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <regex>
#include <string>
#include <type_traits>
#include <vector>

using namespace osgTreeWind;

namespace {

struct Member {
    std::string name;
    std::size_t first, floats; ///< Place and size in floats.
};

template <typename T>
Member member(const char* name, std::size_t offset) {
    static_assert(std::is_same_v<std::remove_all_extents_t<T>, float> ||
                  std::is_same_v<T, std::array<std::array<float, 4>, TreeFall::maxParts>>);
    return {name, offset / sizeof(float), sizeof(T) / sizeof(float)};
}
#define MEMBER(name) member<decltype(PoseRequest::name)>(#name, offsetof(PoseRequest, name))

const std::vector<Member>& members() {
    static const std::vector<Member> all = {MEMBER(firstTexel),
                                            MEMBER(rowTexels),
                                            MEMBER(maxAngle),
                                            MEMBER(streamlining),
                                            MEMBER(across),
                                            MEMBER(upward),
                                            MEMBER(streamlinedTo),
                                            MEMBER(maxPull),
                                            MEMBER(vector),
                                            MEMBER(patchWinds),
                                            MEMBER(breezeStreamlining),
                                            MEMBER(firstUnit),
                                            MEMBER(units),
                                            MEMBER(unused),
                                            MEMBER(fallen)};
    return all;
}

/// The members that the functions of the shader read: names by function and component. Reads of whole
/// elements of an array start at the array.
std::map<std::string, std::vector<std::string>> membersRead(const std::string& shader) {
    std::map<std::string, std::vector<std::string>> read;
    const std::regex function(R"(i?vec([234]) (\w+)\(int tree[^)]*\) \{ return ([^}]*); \})"),
        texel(R"(request\(tree, (\d+)( \+ \w+)?\)(?:\.([xyzw]+))?)");
    for (std::sregex_iterator found(shader.begin(), shader.end(), function), end; found != end; ++found) {
        const std::string body = (*found)[3];
        if (body.find("request(") != 0 && body.find("vec4(request(") != 0 && body.find("ivec2(request(") != 0)
            continue;
        std::vector<std::string>& names = read[(*found)[2]];
        for (std::sregex_iterator at(body.begin(), body.end(), texel); at != end; ++at) {
            const bool isElement = (*at)[2].matched;
            const std::string components = (*at)[3].matched ? (*at)[3].str() : "xyzw";
            for (const char component : components) {
                const std::size_t place = 4 * std::stoul((*at)[1]) + std::string("xyzw").find(component);
                for (const Member& each : members())
                    if (place >= each.first && place < each.first + each.floats) {
                        names.push_back(each.name);
                        EXPECT_EQ(isElement, each.floats > 4) << each.name;
                        EXPECT_TRUE(!isElement || place < each.first + 4) << each.name;
                    }
            }
        }
        EXPECT_EQ(names.size(), std::stoul((*found)[1])) << (*found)[2];
    }
    return read;
}

} // namespace

TEST(PoseRequest, MembersFollowEachOtherWithoutGaps) {
    std::size_t place = 0;
    for (const Member& each : members()) {
        EXPECT_EQ(each.first, place) << each.name;
        place += each.floats;
    }
    EXPECT_EQ(place, 4 * PoseRequest::texels);
}

TEST(PoseRequest, ShadersReadItsMembers) {
    using Names = std::vector<std::string>;
    const std::string shader = shaderText("pose_request.glsl");
    const std::map<std::string, Names> expected = {
        {"matrixOf", {"firstTexel", "rowTexels", "maxAngle"}},
        {"axesOf", {"across", "across", "upward"}},
        {"foliageOf", {"streamlining", "breezeStreamlining", "streamlinedTo", "maxPull"}},
        {"unitsOf", {"firstUnit", "units"}},
        {"fallenPart", Names(4, "fallen")},
        {"shortVector", Names(4, "vector")},
        {"patchWind", Names(3, "patchWinds")}};
    EXPECT_EQ(membersRead(shader), expected);
    std::smatch most;
    ASSERT_TRUE(std::regex_search(shader, most, std::regex(R"(const int mostFallen = (\d+);)")));
    EXPECT_EQ(std::stoul(most[1]), TreeFall::maxParts);
}
