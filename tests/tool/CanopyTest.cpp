// SPDX-License-Identifier: MIT
#include <tests/places/GeoJson.h>
#include <tests/tool/NetCdf.h>
#include <tests/tool/Tool.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <map>
#include <tuple>

namespace {

using Json = nlohmann::json;

double sumOf(const std::vector<double>& densities, double volume) {
    double sum = 0.0;
    for (const double density : densities)
        sum += density == -9999.0 ? 0.0 : density * volume;
    return sum;
}

/// Both arrays of a .vti file, by name.
std::map<std::string, std::vector<double>> arraysOf(const std::string& vti) {
    std::map<std::string, std::vector<double>> arrays;
    std::size_t at = vti.find("\n_") + 2;
    for (const char* name : {"lad", "cda"}) {
        std::uint64_t bytes = 0;
        std::memcpy(&bytes, vti.data() + at, sizeof bytes);
        std::vector<float> numbers(bytes / sizeof(float));
        EXPECT_LE(at + sizeof bytes + bytes, vti.size());
        std::memcpy(numbers.data(), vti.data() + at + sizeof bytes, bytes);
        arrays[name].assign(numbers.begin(), numbers.end());
        at += sizeof bytes + bytes;
    }
    EXPECT_EQ(vti.substr(at), "\n</AppendedData>\n</VTKFile>\n");
    return arrays;
}

class CanopyTool : public testing::Test {
protected:
    const TemporaryFolder folder;

    Outcome canopy(std::vector<std::string> words) const {
        words.insert(words.begin(), "canopy");
        return runTool(words, folder.path());
    }
    Json write(const std::string& name, std::vector<std::string> words) const {
        words.insert(words.end(), {"-o", name, "--json"});
        const Outcome outcome = canopy(words);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        const Json summary = Json::parse(outcome.out, nullptr, false);
        EXPECT_FALSE(summary.is_discarded()) << outcome.out;
        return summary;
    }
    std::string at(const std::string& name) const { return folder.path() + '/' + name; }
    std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
            names.push_back(entry.path().filename());
        return names;
    }
    std::string treeOnMap() const {
        return folder.write("map.treewind", "version = 1\ncrs = \"EPSG:25832\"\n"
                                            "origin = [500000.0, 0.0, 0.0]\n"
                                            "[[tree]]\nposition = [500005.0, 5.0, 30.0]\nspecies = \"oak\"\n"
                                            "height = 12.0\n");
    }
};

} // namespace

TEST_F(CanopyTool, WritesAPalmStaticDriver) {
    const Json summary = write("canopy.nc", {example("forest.treewind"), "--cell", "2,2,1"});
    const NetCdf file(at("canopy.nc"));
    EXPECT_EQ(file.dimensionsOf("lad"), (std::vector<std::string>{"zlad", "y", "x"}));
    EXPECT_EQ(file.typeOf("lad"), NC_FLOAT);
    EXPECT_EQ(file.text("lad", "units"), "m2 m-3");
    EXPECT_EQ(file.text("lad", "long_name"), "leaf area density");
    EXPECT_EQ(file.number("lad", "_FillValue"), -9999.0);
    EXPECT_EQ(file.text("zlad", "positive"), "up");
    for (const char* needed :
         {"origin_x", "origin_y", "origin_z", "origin_lat", "origin_lon", "rotation_angle"})
        EXPECT_EQ(file.number("", needed), needed[7] == 'x'   ? summary["low"][0].get<double>()
                                           : needed[7] == 'y' ? summary["low"][1].get<double>()
                                                              : 0.0);
    EXPECT_EQ(file.text("", "origin_time"), "2001-08-06 12:00:00 +00");

    const std::vector<double> zlad = file.numbers("zlad"), x = file.numbers("x"), lad = file.numbers("lad");
    EXPECT_EQ(std::vector<double>(zlad.begin(), zlad.begin() + 3), (std::vector<double>{0.0, 0.5, 1.5}));
    EXPECT_EQ(std::vector<double>(x.begin(), x.begin() + 2), (std::vector<double>{1.0, 3.0}));
    EXPECT_NEAR(sumOf(lad, 4.0), summary["leafArea"], 1e-5 * summary["leafArea"].get<double>());
    EXPECT_NEAR(sumOf(file.numbers("cda"), 4.0), summary["dragArea"],
                1e-5 * summary["dragArea"].get<double>());

    // A column has the fill value at all levels or at no level, and its first level is the ground.
    const std::size_t columns = lad.size() / zlad.size();
    std::size_t bare = 0;
    for (std::size_t column = 0; column < columns; ++column) {
        bare += lad[column] == -9999.0;
        for (std::size_t level = 0; level < zlad.size(); ++level)
            EXPECT_EQ(lad[level * columns + column] == -9999.0, lad[column] == -9999.0);
        EXPECT_TRUE(lad[column] == -9999.0 || lad[column] == 0.0);
    }
    EXPECT_GT(bare, 0u);
    EXPECT_LT(bare, columns);
}

TEST_F(CanopyTool, WritesTheSameFieldAsCfAndVtk) {
    const std::string forest = example("forest.treewind");
    const Json summary = write("canopy.vti", {forest, "--cell", "2"});
    EXPECT_EQ(write("cf.nc", {forest, "--cell", "2", "--format", "cf"}), summary);
    const NetCdf cf(at("cf.nc"));
    EXPECT_EQ(cf.dimensionsOf("lad"), (std::vector<std::string>{"z", "y", "x"}));
    const std::string vti = contentOf(at("canopy.vti"));
    const auto arrays = arraysOf(vti);
    for (const char* name : {"lad", "cda"})
        EXPECT_EQ(arrays.at(name), cf.numbers(name)) << name;
    EXPECT_NEAR(sumOf(arrays.at("lad"), 8.0), summary["leafArea"], 1e-5 * summary["leafArea"].get<double>());
    EXPECT_EQ(cf.numbers("x").front(), summary["low"][0].get<double>() + 1.0);
    const auto low = [&](int axis) { return std::to_string(summary["low"][axis].get<int>()); };
    EXPECT_NE(vti.find("Origin=\"" + low(0) + ' ' + low(1) + " 0\" Spacing=\"2 2 2\""), std::string::npos);
}

/// The forest stands on the central meridian at the equator.
TEST_F(CanopyTool, UsesTheMapOfTheForest) {
    const std::string forest = treeOnMap();
    write("palm.nc", {forest, "--cell", "1", "--bounds", "500000,0,500010,10"});
    const NetCdf palm(at("palm.nc"));
    EXPECT_NEAR(palm.number("", "origin_lon"), 9.0, 1e-9);
    EXPECT_NEAR(palm.number("", "origin_lat"), 0.0, 1e-9);
    EXPECT_EQ(palm.number("", "origin_x"), 500000.0);
    EXPECT_EQ(palm.text("crs", "epsg_code"), "EPSG:25832");
    EXPECT_EQ(palm.numbers("x").front(), 0.5) << "from the origin";
    EXPECT_EQ(palm.numbers("zlad")[1], 0.5) << "above the foot";

    write("cf.nc", {forest, "--cell", "1", "--bounds", "500000,0,500010,10", "--format", "cf"});
    const NetCdf cf(at("cf.nc"));
    EXPECT_EQ(cf.text("lad", "grid_mapping"), "crs");
    EXPECT_EQ(cf.text("crs", "grid_mapping_name"), "transverse_mercator");
    EXPECT_EQ(cf.text("x", "standard_name"), "projection_x_coordinate");
    EXPECT_EQ(cf.numbers("x").front(), 500000.5);
    EXPECT_EQ(cf.numbers("z").front(), 30.5);
    if (hasProgram("gdalinfo")) {
        const Outcome seen = runShell("gdalinfo NETCDF:cf.nc:lad", folder.path());
        EXPECT_NE(seen.out.find("ETRS89 / UTM zone 32N"), std::string::npos) << seen.out;
    }
}

TEST_F(CanopyTool, OaksHaveNoLeafAreaInWinter) {
    const std::string forest = treeOnMap();
    const Json summer = write("summer.nc", {forest, "--cell", "1", "--season", "summer"}),
               winter = write("winter.nc", {forest, "--cell", "1", "--season", "winter"});
    EXPECT_GT(summer["leafArea"], 10.0);
    EXPECT_EQ(winter["leafArea"], 0.0);
    EXPECT_TRUE(winter["dragCoefficient"].is_null());
    EXPECT_GT(winter["dragArea"], 0.1);
    EXPECT_LT(winter["dragArea"], summer["dragArea"]);
    EXPECT_EQ(sumOf(NetCdf(at("winter.nc")).numbers("lad"), 1.0), 0.0);
}

TEST_F(CanopyTool, NotesTheAreaOutsideTheBounds) {
    const std::string forest = treeOnMap();
    const Outcome outcome =
        canopy({forest, "-o", "half.nc", "--cell", "1", "--bounds", "500000,0,500005,10"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("of the trees' drag area is outside --bounds"), std::string::npos)
        << outcome.err;
}

TEST_F(CanopyTool, RefusesInvalidOptions) {
    const std::string forest = treeOnMap();
    const std::vector<std::string> output = {forest, "-o", "canopy.nc"};
    for (const auto& [words, message] :
         {std::pair<std::vector<std::string>, const char*>{{}, "--cell is required"},
          {{"--cell", "0"}, "--cell: expected a number from 0.01"},
          {{"--cell", "nan"}, "--cell: expected a number from 0.01"},
          {{"--cell", "1,2"}, "--cell: expected DX or DX,DY,DZ, found two numbers"},
          {{"--cell", "2", "--bounds", "500000,0,500011,10"},
           "--bounds: expected a whole number of cells of 2 m, at least 1, between 500000 and 500011, found "
           "5.5"},
          {{"--cell", "1", "--bounds", "0,0,1e6,1e6"},
           "--cell: expected a size that makes at most 4000000000"},
          {{"--cell", "1", "--bounds", "0,0,1"}, "--bounds"},
          {{"--cell", "1", "--format", "gltf"}, "--format"},
          {{"--cell", "1", "--season", "monsoon"}, "--season: expected winter"}}) {
        std::vector<std::string> all = output;
        all.insert(all.end(), words.begin(), words.end());
        const Outcome outcome = canopy(all);
        EXPECT_EQ(outcome.exitCode, 2) << message;
        EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    }
    const Outcome unnamed = canopy({forest, "-o", "canopy.txt", "--cell", "1"});
    EXPECT_EQ(unnamed.exitCode, 2);
    EXPECT_EQ(unnamed.err,
              "--output: expected a name that ends in .nc or .vti, or a --format, found canopy.txt\n");
    const Outcome huge = runTool({"canopy", forest, "-o", "canopy.nc", "--cell", "0.1"}, folder.path(),
                                 "OSGTREEWIND_MAX_MEMORY=1M ");
    EXPECT_EQ(huge.exitCode, 2);
    EXPECT_NE(huge.err.find("MB of memory; the limit is 1 MB (set another with OSGTREEWIND_MAX_MEMORY"),
              std::string::npos)
        << huge.err;
    EXPECT_EQ(files(), std::vector<std::string>{"map.treewind"});
}

/// The disk is full after 32 kB: there is one line of error, and the old file stays.
TEST_F(CanopyTool, AFullDiskLeavesTheOldFile) {
    for (const char* name : {"canopy.nc", "canopy.vti"}) {
        folder.write(name, "old");
        const Outcome outcome = runShell("trap '' XFSZ; ulimit -f 32; " OSGTREEWIND_TOOL " canopy " +
                                             quoted(example("forest.treewind")) + " --cell 0.5 -o " + name,
                                         folder.path());
        EXPECT_EQ(outcome.exitCode, 1);
        EXPECT_EQ(outcome.err, std::string(name) + ": cannot be written: File too large\n");
        EXPECT_EQ(contentOf(at(name)), "old");
    }
    EXPECT_EQ(files().size(), 2u);
    const Outcome nowhere = canopy({example("forest.treewind"), "-o", "absent/canopy.nc", "--cell", "2"});
    EXPECT_EQ(nowhere.exitCode, 1);
    EXPECT_EQ(nowhere.err, "absent/canopy.nc: cannot be written: there is no folder absent\n");
}

TEST_F(CanopyTool, WritesTheProfileOfAStand) {
    folder.write("leaves.csv", "z_over_h,leaf_area\n0.5,0\n1,3\n");
    const Outcome given = canopy({"--profile", "--leaves", "leaves.csv", "--lai", "4", "--cd", "0.15",
                                  "--height", "30", "-o", "given.csv"});
    EXPECT_EQ(given.exitCode, 0) << given.err;
    const Outcome found = canopy({example("forest.treewind"), "--profile", "-o", "forest.csv"});
    EXPECT_EQ(found.exitCode, 0) << found.err;
    for (const auto& [name, top] :
         {std::pair("given.csv", "1,30,1,1,1.8,1.6,1.1\n"), {"forest.csv", ",1,1,1.8,1.6,1.1\n"}}) {
        const std::string table = contentOf(at(name));
        EXPECT_EQ(
            table.find("z_over_h,z_m,u_over_uh,stress_over_ustar2,sigma_u_over_ustar,sigma_v_over_ustar,"
                       "sigma_w_over_ustar\n0,0,0."),
            0u)
            << table;
        EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 66);
        EXPECT_EQ(table.substr(table.size() - std::strlen(top)), top);
    }
}

TEST_F(CanopyTool, RefusesInvalidProfiles) {
    folder.write("leaves.csv", "z_over_h,leaf_area\n1,3\n");
    folder.write("order.csv", "z_over_h,leaf_area\n0.5,1\n0.4,2\n");
    folder.write("high.csv", "z_over_h,leaf_area\n0.5,1\n1.4,2\n");
    folder.write("bare.csv", "z_over_h,leaf_area\n1,0\n");
    folder.write("named.csv", "z,leaf_area\n1,1\n");
    const std::size_t count = files().size();
    for (const auto& [words, message] :
         {std::pair<std::vector<std::string>, const char*>{{}, "a file or --leaves is required"},
          {{"--leaves", "leaves.csv"}, "--leaves: expected a --lai above 0"},
          {{"--leaves", "leaves.csv", "--lai", "nan"}, "--lai: expected a number from 0"},
          {{"--lai", "2"}, "--lai"},
          {{"--leaves", "absent.csv", "--lai", "2"}, "absent.csv: no such file"},
          {{"--leaves", "order.csv", "--lai", "2"},
           "order.csv:3: z_over_h: expected a height above that of the row before, found '0.4'"},
          {{"--leaves", "high.csv", "--lai", "2"}, "high.csv:3: z_over_h: expected a number"},
          {{"--leaves", "bare.csv", "--lai", "2"}, "bare.csv: expected rows with leaf_area above 0"},
          {{"--leaves", "named.csv", "--lai", "2"}, "named.csv:1: expected the columns z_over_h, leaf_area"},
          {{example("forest.treewind"), "--cell", "2"}, "--cell excludes --profile"}}) {
        std::vector<std::string> all = {"--profile", "-o", "profile.csv"};
        all.insert(all.end(), words.begin(), words.end());
        const Outcome outcome = canopy(all);
        EXPECT_EQ(outcome.exitCode, 2) << message;
        EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(files().size(), count);
}

TEST_F(CanopyTool, FollowsALinkAndRefusesAFolder) {
    const std::string forest = treeOnMap();
    std::filesystem::create_directory(at("far"));
    folder.write("far/canopy.nc", "old");
    std::filesystem::create_symlink("far/canopy.nc", at("canopy.nc"));
    write("canopy.nc", {forest, "--cell", "1"});
    EXPECT_TRUE(std::filesystem::is_symlink(at("canopy.nc")));
    EXPECT_GT(std::filesystem::file_size(at("far/canopy.nc")), 1000u);

    std::filesystem::create_directory(at("folder.nc"));
    const Outcome outcome = canopy({forest, "--cell", "1", "-o", "folder.nc"});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_EQ(outcome.err, "--output: folder.nc exists and is not a regular file; choose another name\n");
}
