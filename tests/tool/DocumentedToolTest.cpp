// SPDX-License-Identifier: MIT
#include <tests/tool/DocumentedFields.h>
#include <tests/tool/Tool.h>

#include <algorithm>

namespace {

using OrderedJson = nlohmann::ordered_json;

const std::string forest = example("forest.treewind");

/// The JSON that a command prints.
OrderedJson printed(const std::vector<std::string>& words, const std::string& folder = ".") {
    const Outcome outcome = runTool(words, folder);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    const OrderedJson json = OrderedJson::parse(outcome.out, nullptr, false);
    EXPECT_TRUE(json.is_object()) << outcome.out;
    return json;
}

/// Expects the table of a command in tool.md to have exactly the fields of these documents.
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

/// The commands that `osgtreewind --help` lists.
std::vector<std::string> commandsInHelp() {
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

TEST(DocumentedTool, TheTableOfCommandsHasARowWithAnExampleForEachCommand) {
    const DocumentedFields rows = documentedFields(pageOf("tool.md"), "| command |");
    const std::vector<std::string> commands = commandsInHelp();
    EXPECT_GT(commands.size(), 10u);
    EXPECT_EQ(rows.size(), commands.size());
    for (const std::string& command : commands) {
        const auto row = rows.find(command);
        ASSERT_NE(row, rows.end()) << command << " is not in docs/tool.md";
        const auto isExample = [&](const std::string& quoted) {
            return quoted.rfind("osgtreewind " + command + ' ', 0) == 0;
        };
        EXPECT_TRUE(std::any_of(row->second.begin(), row->second.end(), isExample)) << command;
    }
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
    expectDocumented("portrait", {printed({"portrait", "palm", "--json"})});
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
