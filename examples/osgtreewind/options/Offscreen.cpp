// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Offscreen.h>

#include <osgTreeWind/offscreen/OffscreenContext.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Program.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

PictureSize parsePictureSize(const std::string& text, int largest) {
    static const std::regex form("([0-9]{1,5})x([0-9]{1,5})");
    std::smatch match;
    if (!std::regex_match(text, match, form))
        throw CLI::ValidationError("--size", "expected WIDTHxHEIGHT, found " + text);
    const PictureSize size{std::stoi(match[1]), std::stoi(match[2])};
    if (std::min(size.width, size.height) < 1 || std::max(size.width, size.height) > largest)
        throw CLI::ValidationError("--size", "expected a width and a height from 1 to " +
                                                 std::to_string(largest) + " pixels, found " + text);
    return size;
}

void addBackendOption(CLI::App& command, std::string& backend) {
    std::string help =
        "osmesa (software) or egl (graphics card if there is one); default: osmesa if it was built";
    std::vector<std::string> choices{"osmesa", "egl"};
    if (osgTreeWind::offscreenBackendName() == std::string("wgl")) { // the only one of Windows
        help = "wgl (the driver of the graphics card)";
        choices = {"wgl"};
    }
    command.add_option("--backend", backend, "Source of OpenGL: " + help)->check(CLI::IsMember(choices));
}

void addProfileOption(CLI::App& command, osgTreeWind::ContextProfile& profile) {
    using osgTreeWind::ContextProfile;
    command
        .add_option("--profile", profile,
                    "OpenGL profile: compatibility or core (default: the one that OSG is built for)")
        ->transform(CLI::Transformer(std::map<std::string, ContextProfile>{
            {"compatibility", ContextProfile::Compatibility}, {"core", ContextProfile::Core}}));
}

void runOtherBackend(const std::string& backend) {
    const std::filesystem::path self = osgTreeWind::programPath();
    const std::filesystem::path other =
        self.parent_path() /
        ((backend == "egl" ? "osgtreewind-egl" : "osgtreewind") + std::string(osgTreeWind::programSuffix));
    if (other == self)
        throw CommandError{Failed, "this osgtreewind was built without the backend \"" + backend +
                                       "\"; choose the other --backend"};
    osgTreeWind::runInstead(other);
    throw CommandError{Failed,
                       osgTreeWind::toText(other) +
                           ": cannot be run; it is the part of osgtreewind that draws with the backend \"" +
                           backend + "\""};
}
