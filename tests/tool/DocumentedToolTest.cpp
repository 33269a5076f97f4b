// SPDX-License-Identifier: MIT
#include <tests/tool/DocumentedFields.h>
#include <tests/tool/Tool.h>

#include <cstdlib>

namespace {

using OrderedJson = nlohmann::ordered_json;

const std::string forest = example("forest.treewind");

/// What a command prints as JSON.
OrderedJson printed(const std::vector<std::string>& words, const std::string& folder = ".") {
    const Outcome outcome = runTool(words, folder);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    const OrderedJson json = OrderedJson::parse(outcome.out, nullptr, false);
    EXPECT_TRUE(json.is_object()) << outcome.out;
    return json;
}

/// That the page tells of all that documents of a command hold, and of nothing else.
void expectDocumented(const std::string& command, const std::vector<OrderedJson>& documents) {
    const DocumentedFields table = documentedFields(pageOf("tool.md"), "| field of `" + command);
    std::set<std::string> fields;
    for (const OrderedJson& document : documents)
        addFields(document, "", fields);
    for (const std::string& field : fields)
        EXPECT_TRUE(isDocumented(table, field)) << field << " is not documented";
    for (const auto& [field, said] : table)
        EXPECT_EQ(fields.count(field), 1u) << field << " is documented, but not written";
}

/// As --help lists them.
std::vector<std::string> commandsOfTheTool() {
    std::istringstream help(runTool({"--help"}).out);
    std::vector<std::string> commands;
    bool within = false;
    for (std::string line; std::getline(help, line);) {
        if (within && line.empty())
            break;
        if (within)
            commands.push_back(line.substr(2, line.find(' ', 2) - 2));
        within = within || line == "Subcommands:";
    }
    return commands;
}

} // namespace

/// With OSGTREEWIND_WRITE_MANUAL in the environment the page is mended.
TEST(DocumentedTool, HelpOfEveryCommandStandsInThePage) {
    std::string page = pageOf("tool.md");
    const std::vector<std::string> commands = commandsOfTheTool();
    EXPECT_GT(commands.size(), 10u);
    for (const std::string& command : commands) {
        const std::string open = "\n## " + command + "\n\n```text\n";
        std::size_t at = page.find(open);
        ASSERT_NE(at, std::string::npos) << command << " is not in docs/tool.md";
        at += open.size();
        const std::size_t end = page.find("```\n", at);
        const std::string help = runTool({command, "--help"}).out;
        if (std::getenv("OSGTREEWIND_WRITE_MANUAL"))
            page.replace(at, end - at, help);
        else
            EXPECT_EQ(page.substr(at, end - at), help);
    }
    if (std::getenv("OSGTREEWIND_WRITE_MANUAL"))
        std::ofstream(OSGTREEWIND_SOURCE_DIR "/docs/tool.md") << page;
}

TEST(DocumentedTool, FieldsOfInfo) {
    const TemporaryFolder folder;
    const std::string scans = folder.write(
        "scans.treewind", "version = 1\ncrs = \"EPSG:32611\"\nsearch = [\"" OSGTREEWIND_TEST_DATA
                          "/scan\"]\n[motion]\nlaw = \"thesis\"\nnoise = \"1/f\"\n[[species]]\nname = "
                          "\"sapling\"\nscan = [\"raycloud.txt\"]\n[[tree]]\nposition = [700000, 5000000]\n");
    expectDocumented("info", {printed({"info", forest, "--json"}), printed({"info", scans, "--json"})});
}

TEST(DocumentedTool, FieldsOfSway) {
    expectDocumented("sway", {printed({"sway", "--species", "oak", "--json"})});
}

TEST(DocumentedTool, FieldsOfStorm) {
    expectDocumented("storm", {printed({"storm", "--species", "oak", "--dbh", "20", "--height", "12",
                                        "--duration", "1300", "--no-critical", "--json"})});
}

TEST(DocumentedTool, FieldsOfPortrait) {
    expectDocumented("portrait", {printed({"portrait", "palm", "--edges", "--motion"})});
}

TEST(DocumentedTool, FieldsOfWind) {
    const std::string file = OSGTREEWIND_TEST_DATA "/wind/small.nc";
    expectDocumented("wind --json", {printed({"wind", file, "--json"})});
    expectDocumented("wind --at", {printed({"wind", file, "--json", "--at", "100,200,2"})});
}

TEST(DocumentedTool, FieldsOfCanopy) {
    const TemporaryFolder folder;
    expectDocumented(
        "canopy", {printed({"canopy", forest, "-o", "canopy.nc", "--cell", "5", "--json"}, folder.path())});
}

TEST(DocumentedTool, FieldsOfTile) {
    const TemporaryFolder folder;
    expectDocumented("tile", {printed({"tile", forest, "-o", "world", "--json"}, folder.path())});
}
