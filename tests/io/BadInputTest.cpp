// SPDX-License-Identifier: MIT
#include <tests/base/IsProblem.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/io/ForestFile.h>

#include <gtest/gtest.h>

#include <ostream>
#include <sstream>
#include <string>

namespace osgTreeWind {

namespace {

/// An invalid document. A '@' in `document`, or else in `content`, marks the position that the problem must
/// have, and is removed before reading.
struct BadInput {
    const char* name;
    std::string document;
    const char* key;     ///< Expected dotted key or column name.
    const char* message; ///< Part of the expected message.
    const char* file = "";
    std::string content = ""; ///< Content of `file`, beside the document.
};

std::ostream& operator<<(std::ostream& out, const BadInput& bad) {
    return out << bad.name;
}

struct Place {
    int line = 0, column = 0;
};

/// Removes the marker from the text. @return its position.
Place takeMarker(std::string& text) {
    const std::size_t at = text.find('@');
    if (at == std::string::npos)
        return {};
    text.erase(at, 1);
    Place place{1, 1};
    for (std::size_t i = 0; i < at; ++i)
        place = text[i] == '\n' ? Place{place.line + 1, 1} : Place{place.line, place.column + 1};
    return place;
}

const std::string head = "version = 1\n";
const std::string tree = "[[tree]]\nposition = [0, 0]\n";
const std::string oak = "[[species]]\nname = \"oak\"\n";
const std::string csvHead = "x,y,h,kind\n";

std::string species(const std::string& lines) {
    return head + tree + oak + lines;
}
std::string oneTree(const std::string& lines) {
    return head + "[[tree]]\n" + lines;
}
std::string wind(const std::string& lines) {
    return head + tree + "[wind]\n" + lines;
}
std::string scatter(const std::string& lines) {
    return head + "[scatter]\ncount = 3\narea = [0, 0, 9, 9]\n" + lines;
}
std::string inventory(const std::string& columns = "x = \"x\", y = \"y\", height = \"h\"",
                      const std::string& lines = "") {
    return head + "[inventory]\nfile = \"a.csv\"\ncolumns = {" + columns + "}\n" + lines;
}
std::string csvWind(const std::string& lines) {
    return wind("kind = \"series\"\nfile = \"a.csv\"\n" + lines);
}

/// A species with the scan a.txt.
std::string scan(const std::string& lines = "") {
    return species("scan = @\"a.txt\"\n" + lines);
}
const std::string qsmRow = "0.1 1 0 0 0 0 0 1 0 2 0 0.1 1 0 1\n"; // the root
std::string qsmNext(const std::string& parent) {
    return "0.1 1 0 0 1 0 0 1 " + parent + " 0 0 0.1 1 0 2\n";
}

const BadInput badInputs[] = {
    // The document as a whole
    {"Empty", "", "", "empty"},
    {"Binary",
     std::string("\x7f"
                 "ELF\2\1\1\0\0\0",
                 10),
     "", "binary"},
    {"NulByte", head + std::string("seed = 1\0", 9), "", "binary"},
    {"InvalidUtf8", head + "# ca@f\xe9\n", "", "not valid TOML"},
    {"BrokenHeader", head + "[@=]\n", "", "not valid TOML"},
    {"Truncated", head + "[wind@\n", "", "not valid TOML"},
    {"LetterBeyondAscii", head + "seed = 3 @é\n", "", "not valid TOML"},
    {"UnclosedString", head + "search = [\"a@\n", "", "not valid TOML"},
    {"KeyTwice", head + tree + "height = 3\nheight = @4\n", "", "not valid TOML"},
    {"NoVersion", "@" + tree, "version", "missing"},
    {"NewerVersion", "version = @2\n" + tree, "version", "expected a whole number in [1, 1], found 2"},
    {"VersionAsText", "version = @\"1\"\n" + tree, "version", "found the text \"1\""},
    {"NoTrees", "@" + head, "", "no trees"},
    {"UnknownKey", head + "@sead = 3\n" + tree, "sead", "did you mean seed?"},
    {"UnknownTable", head + tree + "[@weather]\nkind = \"calm\"\n", "weather", "unknown key; known here: "},
    {"UnknownSeason", head + "season = @\"fall\"\n" + tree, "season",
     "or a date such as 2024-11-05, found 'fall'"},
    {"SeasonBeyondTheYear", head + "season = @4.5\n" + tree, "season", "a number from 0 to 4"},
    {"SeasonOfNoDay", head + "season = @\"2023-02-29\"\n" + tree, "season", "found '2023-02-29'"},
    {"SeasonAsArray", head + "season = @[1]\n" + tree, "season", "expected a number, found an array"},
    {"NegativeSeed", head + "seed = @-1\n" + tree, "seed", "in [0, 4294967295], found -1"},
    {"SearchNotAList", head + "search = @\"data\"\n" + tree, "search", "expected an array of texts"},
    {"EmptySearch", head + "search = [\"a\", @\"\"]\n" + tree, "search", "expected a text in quotes"},
    {"OriginOfTwo", head + "origin = @[1, 2]\n" + tree, "origin", "array of 3 numbers, found 2"},
    {"FarFromOrigin", head + "origin = @[4.3e5, 4.5e6, 0]\n" + tree, "origin", "more than 100 km"},
    {"TreesFarApart", "@" + head + tree + "[[tree]]\nposition = [1e6, 0]\n", "origin", "more than 100 km"},

    // [motion]
    {"UnknownLaw", head + tree + "[motion]\nlaw = @\"newton\"\n", "motion.law",
     "expected \"modal\", \"thesis\" or \"thesis-smooth\""},
    {"UnknownNoise", head + tree + "[motion]\nnoise = @\"simplex\"\n", "motion.noise",
     "expected \"perlin\" or \"1/f\""},
    {"NoiseTooSteep", head + tree + "[motion]\nnoise = \"1/f\"\nnoise_exponent = @3.5\n",
     "motion.noise_exponent", "in [0, 3], found 3.5"},
    {"UnknownNoiseWithExponent", head + tree + "[motion]\nnoise = @\"1/F\"\nnoise_exponent = 2\n",
     "motion.noise", "expected \"perlin\" or \"1/f\""},
    {"ExponentOfPerlin", head + tree + "[motion]\nnoise_exponent = @1\n", "motion.noise_exponent",
     "expected noise = \"1/f\" with it"},
    {"MotionNotATable", head + "motion = @\"thesis\"\n" + tree, "motion", "expected a table, found the text"},

    // [drawing]
    {"TiersAsText", head + tree + "[drawing]\ntiers = @\"off\"\n", "drawing.tiers",
     "expected true or false, found the text \"off\""},
    {"NoPixelsInFull", head + tree + "[drawing]\nfull = @0\n", "drawing.full", "in (0, 100000], found 0"},
    {"ImpostorNegative", head + tree + "[drawing]\nimpostor = @-1\n", "drawing.impostor",
     "in [0, 100000], found -1"},
    {"ReducedAboveFull", head + tree + "[drawing]\nfull = 200\nreduced = @200\n", "drawing.reduced",
     "expected reduced below full, found 200 and 200"},
    {"FullBelowReduced", head + tree + "[drawing]\nfull = @60\n", "drawing.full",
     "expected reduced below full, found 250 and 60"},
    {"ImpostorAboveReduced", head + tree + "[drawing]\nimpostor = @350\n", "drawing.impostor",
     "expected impostor below reduced, found 350 and 250"},
    {"ReducedBelowImpostor", head + tree + "[drawing]\nreduced = @20\n", "drawing.reduced",
     "expected impostor below reduced, found 80 and 20"},
    {"BlendTooWide", head + tree + "[drawing]\nblend = @1\n", "drawing.blend", "in [0, 0.9], found 1"},
    {"ExposureNegative", head + tree + "[drawing]\nexposure = @-1\n", "drawing.exposure",
     "in [0, 1000], found -1"},
    {"BudgetNegative", head + tree + "[drawing]\nbudget = @-1\n", "drawing.budget",
     "in [0, 10000], found -1"},

    // [[species]]
    {"SpeciesEmpty", head + "species = @[]\n" + tree, "species", "at least one"},
    {"SpeciesNameless", head + tree + "@[[species]]\nshapes = 2\n", "species.name", "missing"},
    {"SpeciesTwice", head + tree + "species = \"oak\"\n" + oak + "[[species]]\nname = @\"OAK\"\n",
     "species.name", "taken already"},
    {"AliasTaken", species("aliases = @[\"oak\"]\n"), "species.aliases", "taken already"},
    {"NoShapes", species("shapes = @0\n"), "species.shapes", "in [1, 64], found 0"},
    {"LevelsTooMany", species("[species.tree]\nlevels = @9\n"), "species.tree.levels", "in [0, 8], found 9"},
    {"LevelsNotWhole", species("[species.tree]\nlevels = @2.5\n"), "species.tree.levels", "whole number"},
    {"ShapesTooLarge", species("[species.tree]\nlevels = @8\nchildren_per_branch = 8\n"),
     "species.tree.levels", "more than 1048576 skeleton points"},
    {"ShapesTooMany", head + tree + "@[[species]]\nname = \"a\"\nshapes = 64\n[species.tree]\nlevels = 8\n",
     "species", "at most 50000000 are possible"},
    {"LikeNone", species("like = @\"lamp post\"\n"), "species.like", "no built-in species \"lamp post\""},
    {"CrownOfNoShape", species("[species.growth]\nshape = @\"ball\"\n"), "species.growth.shape",
     "no crown shape is called \"ball\""},
    {"TrunkTwice", species("[species.growth]\nradius = 0.2\ntrunk_diameter = @0.4\n"),
     "species.growth.trunk_diameter", "give either this or radius"},
    {"TwoForms", species("[species.growth]\n@[species.habit]\n"), "species.habit",
     "give either this or growth"},
    {"BranchWood", species("[species.wood]\nbranch_wood = @\"much\"\n"), "species.wood.branch_wood",
     "or \"broadleaf\", found the text \"much\""},
    {"CrownNegative", species("[species.crown]\nper_diameter = @-1\n"), "species.crown.per_diameter",
     "in [0, 100]"},
    {"BoughsTooMany", species("[species.growth.boughs]\ncount = @201\n"), "species.growth.boughs.count",
     "in [0, 200], found 201"},
    {"StemTooThick", species("[species.palm]\nheight = 2\ntrunk_diameter = @1.2\n"),
     "species.palm.trunk_diameter", "at most half the height of the stem"},
    {"StemBelowItsCrown", species("[species.palm]\ntrunk = @0.5\n"), "species.palm.trunk",
     "expected at least crown_base"},
    {"TrunkThickerThanTall", species("[species.tree]\nlength = 0.5\nradius = @0.6\n"), "species.tree.radius",
     "half the trunk"},
    {"LengthNegative", species("[species.tree]\nlength = @-1.0\n"), "species.tree.length", "in [0.01, 100]"},
    {"LengthNaN", species("[species.tree]\nlength = @nan\n"), "species.tree.length", "finite number"},
    {"ModulusInfinite", species("[species.wood]\nelastic_modulus = @inf\n"), "species.wood.elastic_modulus",
     "finite number"},
    {"NumberAsText", species("[species.leaves]\nlength = @\"long\"\n"), "species.leaves.length",
     "expected a number, found the text \"long\""},
    {"AngleTooLarge", species("[species.branch]\nmax_angle = @91.0\n"), "species.branch.max_angle",
     "in [0, 90], found 91"},
    {"LeafFactor", species("[species.leaf]\nfactor = @1.5\n"), "species.leaf.factor", "in [0, 1], found 1.5"},
    {"ColourOfTwo", species("[species.appearance]\nbark = @[0.1, 0.2]\n"), "species.appearance.bark",
     "array of 3 numbers, found 2"},
    {"OldBarkTooBright", species("[species.appearance]\nold_bark = [0.1, 0.2, @2]\n"),
     "species.appearance.old_bark", "in [0, 1], found 2"},
    {"ColourTooBright", species("[species.appearance]\nbark = [0.1, 0.2, @255]\n"), "species.appearance.bark",
     "in [0, 1], found 255"},
    {"LeafFormNotKnown", species("[species.appearance]\nleaf_form = @\"needle\"\n"),
     "species.appearance.leaf_form", "or \"combed\", found the text \"needle\""},
    {"UnknownNestedKey", species("[species.tree]\n@level = 3\n"), "species.tree.level",
     "did you mean levels?"},

    // [[species]] with scan; problems of the file are reported at the key
    {"ScanAbsent", species("scan = @\"no.txt\"\n"), "species.scan", "no file \"no.txt\" in "},
    {"ScanOneOfManyAbsent", species("scan = @[\"a.txt\", \"no.txt\"]\n"), "species.scan",
     "no file \"no.txt\" in ", "a.txt", qsmRow},
    {"UpWithoutScan", species("up = @\"y\"\n"), "species.up", "cannot be used without scan"},
    {"ScanUpX", species("scan = \"a.txt\"\nup = @\"x\"\n"), "species.up", "\"y\" or \"z\"", "a.txt", qsmRow},
    {"ScanNone", species("scan = @[]\n"), "species.scan", "at least one"},
    {"ScanAsNumber", species("scan = @3\n"), "species.scan", "expected a text in quotes, found 3"},
    {"ScanWithTree", species("scan = \"a.txt\"\n@[species.tree]\nlevels = 3\n"), "species.tree",
     "cannot be combined with scan", "a.txt", qsmRow},
    {"ScanWithShapes", species("scan = \"a.txt\"\nshapes = @3\n"), "species.shapes",
     "cannot be combined with scan", "a.txt", qsmRow},
    {"ScanEmpty", scan(), "species.scan", "/a.txt: the file is empty", "a.txt", ""},
    {"ScanBinary", scan(), "species.scan", "/a.txt:1:3: expected text, found binary", "a.txt",
     std::string("1 \0", 3)},
    {"ScanUnknown", scan(), "species.scan", "/a.txt: expected a scanned tree: ", "a.txt", "hello\n"},
    {"ScanLoop", scan(), "species.scan", "/a.txt:2: expected parents that lead to the root, found a loop",
     "a.txt", qsmRow + qsmNext("3") + qsmNext("2")},
    {"ScanParentAbsent", scan(), "species.scan", "/a.txt:2: expected a parent of the same tree, found 7",
     "a.txt", qsmRow + qsmNext("7")},
    {"ScanTwoRoots", scan(), "species.scan",
     "/a.txt:2: expected one root, found a second one besides line 1; branches without a parent have 50 % of "
     "the "
     "wood, and at most 5 % can be joined to the nearest cylinder",
     "a.txt", qsmRow + qsmNext("0")},
    {"ScanTextInNumber", scan(), "species.scan", "/a.txt:2:19: expected the number of the parent cylinder",
     "a.txt", qsmRow + qsmNext("oak")},
    {"ScanRadiusZero", scan(), "species.scan", "/a.txt:2:1: expected a radius above 0", "a.txt",
     qsmRow + "0 1 0 0 1 0 0 1 1 0 0 0.1 1 0 2\n"},
    {"ScanNaN", scan(), "species.scan", "/a.txt:2:7: expected metres within 1e9, found 'nan'", "a.txt",
     qsmRow + "0.1 1 nan 0 1 0 0 1 1 0 0 0.1 1 0 2\n"},
    {"ScanLengthZero", scan(), "species.scan", "/a.txt:2:5: expected a length above 0", "a.txt",
     qsmRow + "0.1 0 0 0 1 0 0 1 1 0 0 0.1 1 0 2\n"},
    {"ScanOverflow", scan(), "species.scan", "/a.txt:2:5: expected a length", "a.txt",
     qsmRow + "0.1 1e999 0 0 1 0 0 1 1 0 0 0.1 1 0 2\n"},
    {"ScanTooFewColumns", scan(), "species.scan", "/a.txt:2: expected 15 or 17 columns", "a.txt",
     qsmRow + "0.1 1 0 0 1 0 0 1 1\n"},
    {"ScanInMillimetres", scan(), "species.scan",
     "/a.txt:2: expected a tree of 0.1 to 150 m above its foot, in metres, found 2000", "a.txt",
     "1 1 0 0 0 9 -1\n2 1 0 0 2000 9 1\n"},
    {"ScanTooManyTrees", scan(), "species.scan", "expected at most 64 trees in all files", "a.txt",
     [] {
         std::string file = "x,y,z,radius,parent_id\n";
         for (int i = 0; i < 65; ++i)
             file += "0,0,0,1,-1, 0,0,9,1,0\n";
         return file;
     }()},

    // [[tree]]
    {"TreeNowhere", head + "@[[tree]]\nheight = 3\n", "tree.position", "missing"},
    {"PositionOfOne", oneTree("position = @[1]\n"), "tree.position", "array of 2 to 3 numbers, found 1"},
    {"PositionWithText", oneTree("position = [1, @\"2\"]\n"), "tree.position", "expected a number"},
    {"PositionAsDate", oneTree("position = @2026-01-01\n"), "tree.position", "found a date"},
    {"HeightZero", oneTree("position = [0, 0]\nheight = @0\n"), "tree.height", "in (0, 150], found 0"},
    {"HeightHuge", oneTree("position = [0, 0]\nheight = @1e300\n"), "tree.height", "found 1e+300"},
    {"SpeciesUnknown", oneTree("position = [0, 0]\nspecies = @\"oakt\"\n") + oak, "tree.species",
     "no species \"oakt\"; did you mean oak?"},
    {"SpeciesLikeABuiltIn", oneTree("position = [0, 0]\nspecies = @\"norway sprus\"\n"), "tree.species",
     "did you mean Norway spruce?"},
    {"SpeciesNowhere", oneTree("position = [0, 0]\nspecies = @\"lamp post\"\n"), "tree.species",
     "known: tree and the built-in ones (osgtreewind sway --list)"},
    {"SpeciesUnclear", head + "@" + tree + oak + "[[species]]\nname = \"fir\"\n", "tree.species", "missing"},
    {"TreeNotATable", head + "tree = @3\n", "tree", "expected a table, found 3"},

    {"IdTwice", head + tree + "id = \"7\"\n" + tree + "id = @\"7\"\n", "tree.id",
     "the id \"7\" is taken already"},

    // [scatter]
    {"BillionTrees", head + "[scatter]\ncount = @1000000000\narea = [0, 0, 9, 9]\n", "scatter.count",
     "more than 1000000 trees"},
    {"MoreThanInteger", head + "[scatter]\ncount = @5000000000\narea = [0, 0, 9, 9]\n", "scatter.count",
     "found 5000000000"},
    {"MillionsInAll",
     head + "[[scatter]]\ncount = 600000\narea = [0, 0, 9, 9]\n" +
         "[[scatter]]\ncount = @600000\narea = [0, 0, 9, 9]\n",
     "scatter.count", "more than 1000000 trees"},
    {"CountMissing", head + "@[scatter]\narea = [0, 0, 9, 9]\n", "scatter.count", "missing"},
    {"AreaReversed", head + "[scatter]\ncount = 1\narea = @[9, 9, 0, 0]\n", "scatter.area", "x0 < x1"},
    {"NoRoom", scatter("spacing = @20.0\n"), "scatter.spacing", "only 1 of 3 trees fit"},
    {"NoRoomForAMillion", head + "[scatter]\ncount = 1000000\narea = [0, 0, 1000, 1000]\nspacing = @0.9\n",
     "scatter.spacing", "only about 861"},
    {"SpacingTiny", scatter("spacing = @1e-300\n"), "scatter.spacing", "0, or at least 0.001"},
    {"WeightsOfOther", scatter("species = [\"oak\"]\nweights = @[1, 2]\n") + oak, "scatter.weights",
     "array of 1 numbers, found 2"},
    {"WeightZero", scatter("weights = [@0]\n"), "scatter.weights", "in (0, 1000000], found 0"},
    {"RangeReversed", scatter("height = @[9, 3]\n"), "scatter.height", "min not above max"},
    {"RatioAlone", scatter("trunk_ratio = @0.03\n"), "scatter.trunk_ratio", "needs height"},
    {"RatioAndSize", scatter("height = 9\ncrown_width = 4\ncrown_ratio = @0.5\n"), "scatter.crown_ratio",
     "give either this or crown_width"},

    {"LeafImageAbsent", species("appearance.leaf_image = @\"no.png\"\n"), "species.appearance.leaf_image",
     "no file \"no.png\" in "},
    {"LeafImageIsNumber", species("appearance.leaf_image = @7\n"), "species.appearance.leaf_image", "text"},
    {"BarkImageIsFolder", species("appearance.bark_image = @\".\"\n"), "species.appearance.bark_image",
     "no file"},

    // [inventory]
    {"InventoryAbsent", head + "[inventory]\nfile = @\"no.csv\"\ncolumns = {x = \"x\", y = \"y\"}\n",
     "inventory.file", "no file \"no.csv\" in "},
    {"InventoryIsFolder", head + "[inventory]\nfile = @\".\"\ncolumns = {x = \"x\", y = \"y\"}\n",
     "inventory.file", "no file"},
    {"ColumnsMissing", head + "@[inventory]\nfile = \"a.csv\"\n", "inventory.columns", "missing", "a.csv",
     csvHead + "1,2,3,oak\n"},
    {"ColumnYMissing", head + "[inventory]\nfile = \"a.csv\"\ncolumns = @{x = \"x\"}\n",
     "inventory.columns.y", "missing", "a.csv", csvHead + "1,2,3,oak\n"},
    {"ColumnAbsent", inventory("x = \"x\", y = \"y\", height = @\"tall\""), "inventory.columns.height",
     "no column \"tall\" in", "a.csv", csvHead + "1,2,3,oak\n"},
    {"ColumnUnknown", inventory("x = \"x\", y = \"y\", @girth = \"h\""), "inventory.columns.girth",
     "unknown key", "a.csv", csvHead + "1,2,3,oak\n"},
    {"UnitUnknown", inventory("x = \"x\", y = \"y\", height = \"h\"", "units = {height = @\"ha\"}\n"),
     "inventory.units.height", "expected a unit of length (m, cm, mm, us-ft, ft, in), found 'ha'", "a.csv",
     csvHead + "1,2,3,oak\n"},
    {"DelimiterUnknown", inventory("x = \"x\", y = \"y\"", "delimiter = @\":\"\n"), "inventory.delimiter",
     "expected \",\"", "a.csv", csvHead + "1,2,3,oak\n"},
    {"DefaultUnknown", inventory("x = \"x\", y = \"y\"", "default_species = @\"kelp\"\n"),
     "inventory.default_species", "no species \"kelp\"", "a.csv", csvHead + "1,2,3,oak\n"},
    {"CsvEmpty", inventory(), "", "empty", "a.csv", ""},
    {"CsvWithoutRows", inventory(), "", "the inventory has no trees", "a.csv", "@" + csvHead},
    {"CsvRagged", inventory(), "", "expected 4", "a.csv", csvHead + "1,2,3,oak\n@1,2,3\n"},
    {"CsvNaN", inventory(), "y", "found", "a.csv", csvHead + "1,@nan,3,oak\n"},
    {"CsvNoPosition", inventory(), "x", "found", "a.csv", csvHead + "@,2,3,oak\n"},
    {"CsvBinary", inventory(), "", "", "a.csv", csvHead + std::string("@1,2,\0,oak\n", 11)},

    // [wind]
    {"WindKindless", head + tree + "@[wind]\nspeed = 3.0\n", "wind.kind", "missing"},
    {"WindKindUnknown", wind("kind = @\"gale\"\nspeed = 3.0\n"), "wind.kind", "\"calm\", \"uniform\""},
    {"WindSourceUnknown", wind("kind = \"calm\"\n[[wind.source]]\nkind = @\"gale\"\nplace = [0, 0, 1]\n"),
     "wind.source.kind", "\"rotor\", \"jet\""},
    {"WindSourceNowhere", wind("kind = \"calm\"\n@[[wind.source]]\nkind = \"jet\"\n"), "wind.source.position",
     "missing"},
    {"WindSourceTwice",
     wind("kind = \"calm\"\n[[wind.source]]\nkind = \"jet\"\nplace = @[0, 0, 1]\nposition = [0, 0, 1]\n"),
     "wind.source.place", "either this or position"},
    {"WindSourceRadius",
     wind("kind = \"calm\"\n[[wind.source]]\nkind = \"jet\"\nplace = [0, 0, 1]\nradius = @0\n"),
     "wind.source.radius", "(0, 1000]"},
    {"WindCanopyUnknown", wind("kind = \"calm\"\ncanopy = @\"dense\"\n"), "wind.canopy",
     "\"none\", \"forest\", \"given\" or \"auto\""},
    {"WindCanopyBare", wind("kind = \"calm\"\ncanopy_frontal_area = @0\n"), "wind.canopy_frontal_area",
     "0.01"},
    {"WindNothing", head + tree + "@[wind]\nkind = \"uniform\"\n", "wind", "either velocity, or speed"},
    {"WindDirectionless", wind("kind = \"uniform\"\nspeed = @3.0\n"), "wind.speed", "direction_from"},
    {"WindBothDirections",
     wind("kind = \"uniform\"\nspeed = @3.0\ndirection_from = 1.0\ndirection_toward = 2.0\n"), "wind.speed",
     "either direction_from or direction_toward"},
    {"WindVelocityAndDirection", wind("kind = \"uniform\"\nvelocity = [1, 2, 0]\ndirection_from = @3.0\n"),
     "wind.direction_from", "velocity already gives the direction"},
    {"WindSpeedNegative", wind("kind = \"uniform\"\nspeed = @-3.0\ndirection_from = 1.0\n"), "wind.speed",
     "in [0, 200]"},
    {"WindUnitUnknown", wind("kind = \"uniform\"\nvelocity = [1, 2, 0]\nunit = @\"furlong\"\n"), "wind.unit",
     "m/s"},
    {"WindInfinite", wind("kind = \"uniform\"\nvelocity = [1, @inf, 0]\n"), "wind.velocity", "finite number"},
    {"WindKeyOfOtherKind", wind("kind = \"calm\"\n@speed = 3.0\n"), "wind.speed", "unknown key"},
    {"GridLength", wind("kind = \"grid\"\npoints = [2, 2]\ncell = [5, 5]\nvalues = @[1, 0, 0]\n"),
     "wind.values", "12"},
    {"GridHuge",
     wind("kind = \"grid\"\npoints = [99999, 99999, 99999]\ncell = [5, 5, 5]\nvalues = @[1, 0]\n"),
     "wind.values", ""},
    {"GridCellZero", wind("kind = \"grid\"\npoints = [1, 1]\ncell = [@0, 5]\nvalues = [1, 0, 0]\n"),
     "wind.cell", "in (0, 1000000]"},
    {"GridHalfPoints", wind("kind = \"grid\"\npoints = @[1.5, 1]\ncell = [5, 5]\nvalues = [1, 0, 0]\n"),
     "wind.points", "whole numbers"},
    {"GridTimes",
     wind("kind = \"grid\"\npoints = [1, 1]\ncell = [5, 5]\ntimes = @[1, 1]\n"
          "values = [1, 0, 0, 1, 0, 0]\n"),
     "wind.times", "increas"},
    {"GridBothSources",
     head + tree +
         "@[wind]\nkind = \"grid\"\npoints = [1, 1]\ncell = [5, 5]\nvalues = [1, 0, 0]\n"
         "file = \"a.txt\"\n",
     "wind", "either values or file", "a.txt", "1 0 0"},
    {"GridFileText", wind("kind = \"grid\"\npoints = [1, 1]\ncell = [5, 5]\nfile = \"a.txt\"\n"), "",
     "expected a finite number", "a.txt", "1 0\n @zero"},
    {"GridTwoPlaces",
     wind("kind = \"grid\"\npoints = [1, 1]\ncell = [5, 5]\nvalues = [1, 0, 0]\norigin = [0, 0, 0]\n"
          "corner = @[0, 0, 0]\n"),
     "wind.corner", "give either this or origin"},
    {"GridHeights",
     wind("kind = \"grid\"\npoints = [1, 1, 2]\ncell = [5, 5, 5]\nheights = @[3, 2]\n"
          "values = [1, 0, 0, 1, 0, 0]\n"),
     "wind.heights", "increasing upward"},
    {"ForestWindLength", wind("kind = \"forest_wind\"\nwidth = 2\nlength = 1\nvalues = @[1, 2, 3]\n"),
     "wind.values", "6"},
    {"ForestWindWidth", wind("kind = \"forest_wind\"\nwidth = @0\nlength = 1\nvalues = [1, 2, 3]\n"),
     "wind.width", "in [1, 100000], found 0"},
    {"SeriesUneven", wind("kind = \"series\"\ntimes = [0, 1]\nvelocities = @[[1, 0, 0]]\n"),
     "wind.velocities", ""},
    {"SeriesFlat", wind("kind = \"series\"\ntimes = [0]\nvelocities = [@1, 0, 0]\n"), "wind.velocities",
     "array of 3 numbers, found 1"},
    {"SeriesBackwards", wind("kind = \"series\"\ntimes = @[1, 0]\nvelocities = [[1, 0, 0], [1, 0, 0]]\n"),
     "wind.times", "increas"},
    {"SeriesRoughness",
     wind("kind = \"series\"\ntimes = [0]\nvelocities = [[1, 0, 0]]\nheight = 2\nroughness = @3\n"),
     "wind.roughness", "less than height"},
    {"SeriesAbsent", wind("kind = \"series\"\nfile = @\"no.xml\"\n"), "wind.file", "no file"},
    {"SeriesColumnAbsent", csvWind("columns = {time = \"t\", u = \"u\", v = \"w\"}\n"), "w",
     "no such column for v", "a.csv", "@t,u,v\n0,1,2\n1,2,3\n"},
    {"SeriesUnitUnknown",
     csvWind("speed_unit = @\"beaufort\"\ncolumns = {time = \"t\", u = \"u\", v = \"v\"}\n"),
     "wind.speed_unit", "m/s", "a.csv", "t,u,v\n0,1,2\n1,2,3\n"},
    {"SeriesTimeUnitUnknown",
     csvWind("time_unit = @\"fortnight\"\ncolumns = {time = \"t\", u = \"u\", v = \"v\"}\n"),
     "wind.time_unit", "min", "a.csv", "t,u,v\n0,1,2\n1,2,3\n"},
    {"SeriesTextInNumber", csvWind("columns = {time = \"t\", u = \"u\", v = \"v\"}\n"), "u", "found", "a.csv",
     "t,u,v\n0,1,2\n1,@calm,3\n"},
    {"SeriesXmlBroken", wind("kind = \"series\"\nfile = \"a.xml\"\n"), "", "", "a.xml",
     "<timeSeries>\n<timeEpoch> 1 </time@Epoch"},
    {"FileAndFiles", wind("kind = \"file\"\nfile = \"a.csv\"\nfiles = @[\"a.csv\"]\ntimes = [0]\n"),
     "wind.files", "give either this or file", "a.csv", "1"},
    {"FilesWithoutTimes", head + tree + "@[wind]\nkind = \"file\"\nfiles = [\"a.csv\", \"a.csv\"]\n", "wind",
     "expected one time for each file", "a.csv",
     "# vtk DataFile Version 3.0\none point\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 1 1 1\n"
     "POINT_DATA 1\nVECTORS wind float\n1 2 0\n"},
    {"FileWithTimes", wind("kind = \"file\"\nfile = \"a.csv\"\ntimes = @[0]\n"), "wind.times",
     "cannot be used without files", "a.csv", "1"},
    {"FilesCount", wind("kind = \"file\"\nfiles = [\"a.csv\", \"a.csv\"]\ntimes = @[0]\n"), "wind.times",
     "expected 2 numbers, one for each file, found 1", "a.csv", "1"},
    {"FilesBackwards", wind("kind = \"file\"\nfiles = [\"a.csv\", \"a.csv\"]\ntimes = @[1, 0]\n"),
     "wind.times", "increas", "a.csv", "1"},
    {"FilesEmpty", wind("kind = \"file\"\nfiles = @[]\ntimes = [0]\n"), "wind.files", "at least one"},
    {"FilesAsText", wind("kind = \"file\"\nfiles = @\"a.csv\"\ntimes = [0]\n"), "wind.files",
     "expected an array of texts", "a.csv", "1"},
    {"FilesAbsent", wind("kind = \"file\"\nfiles = @[\"a.csv\", \"no.asc\"]\ntimes = [0, 1]\n"), "wind.files",
     "no file \"no.asc\" in ", "a.csv", "1"},
    {"FilesNoGrid", wind("kind = \"file\"\nfiles = [\"a.csv\"]\ntimes = [0]\n"), "",
     "expected a grid at one time, found a record", "a.csv", "time,u,v\n0,1,2\n"},
    {"FileUnitUnknown", wind("kind = \"file\"\nfile = \"a.csv\"\nspeed_unit = @\"beaufort\"\n"),
     "wind.speed_unit", "expected a unit of speed", "a.csv", "time,u,v\n0,1,2\n"},
    {"FileVariableOfATable", wind("kind = \"file\"\nfile = \"a.csv\"\nvariable = @\"U\"\n"), "wind.variable",
     "a file of the format .csv has only one wind", "a.csv", "time,u,v\n0,1,2\n"},
    {"FileVariableAbsent", wind("kind = \"file\"\nfile = \"a.vtk\"\nvariable = \"U\"\n"), "",
     "that wind.variable names; found wind (3)", "a.vtk",
     "# vtk DataFile Version 3.0\none point\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 1 1 1\n"
     "POINT_DATA 1\nVECTORS wind float\n1 2 @0"},
    {"TimeScaleInfinite", wind("kind = \"calm\"\ntime_scale = @inf\n"), "wind.time_scale", "finite number"},
};

class BadInputTest : public testing::TestWithParam<BadInput> {};

} // namespace

TEST_P(BadInputTest, GivesOneProblemWithItsPosition) {
    const BadInput& bad = GetParam();
    const TemporaryFolder folder;
    std::string document = bad.document, content = bad.content;
    const Place inDocument = takeMarker(document), inContent = takeMarker(content);
    if (*bad.file)
        folder.write(bad.file, content);

    std::istringstream input(document);
    const auto result = readForest(input, {"bad.treewind", folder.path()});
    ASSERT_FALSE(result.ok());
    ASSERT_EQ(result.problems().size(), 1u) << result.problems()[1].text();
    const Diagnostic& problem = result.problems().front();
    SCOPED_TRACE(problem.text());

    const bool inFile = inDocument.line == 0 && *bad.file;
    EXPECT_EQ(problem.file, inFile ? folder.path() + '/' + bad.file : "bad.treewind");
    if (const Place place = inFile ? inContent : inDocument; place.line > 0) {
        EXPECT_EQ(problem.line, place.line);
        if (!inFile) { // problems in CSV files have no column
            EXPECT_EQ(problem.column, place.column);
        }
    }
    EXPECT_EQ(problem.key, bad.key);
    EXPECT_TRUE(hasPart(problem.message, bad.message));
    EXPECT_FALSE(problem.message.empty());
}

INSTANTIATE_TEST_SUITE_P(All, BadInputTest, testing::ValuesIn(badInputs),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(BadInput, ReportsAMissingFile) {
    const auto result = readForestFile("/nowhere/at/all.treewind");
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.problems().front().text(), "/nowhere/at/all.treewind: no such file");
}

TEST(BadInput, RejectsAFolder) {
    const TemporaryFolder folder;
    const auto result = readForestFile(folder.path());
    ASSERT_FALSE(result.ok());
    EXPECT_TRUE(hasPart(result.problems().front().message, "not a regular file"));
}

TEST(BadInput, RejectsKeysWithTooManyParts) {
    std::string key = "a";
    for (int i = 0; i < 250000; ++i)
        key += ".a";
    for (const std::string& text :
         {"version = 1\n" + key + " = 1\n", "version = 1\n[" + key + "]\n", "x = {" + key + " = 1}\n"}) {
        std::istringstream input(text);
        const auto result = readForest(input);
        ASSERT_FALSE(result.ok());
        EXPECT_EQ(result.problems().front().message, "expected keys of at most 200 parts");
    }
}

TEST(BadInput, ReportsAllProblemsInTheOrderOfTheFile) {
    std::istringstream input(
        "seed = -1\n[wind]\nkind = \"gale\"\n[[tree]]\nheight = 0\n[[tree]]\nposition = 3\n"
        "colour = 1\n");
    const auto result = readForest(input, {"f", ""});
    ASSERT_FALSE(result.ok());
    std::vector<std::string> places;
    for (const Diagnostic& problem : result.problems())
        places.push_back(std::to_string(problem.line) + ' ' + problem.key);
    EXPECT_EQ(places, (std::vector<std::string>{"1 version", "1 seed", "3 wind.kind", "4 tree.position",
                                                "5 tree.height", "7 tree.position", "8 tree.colour"}));
}

TEST(BadInput, LimitsTheNumberOfProblems) {
    std::string document = head;
    for (int i = 0; i < 1000; ++i)
        document += "[[tree]]\n";
    std::istringstream input(document);
    const auto result = readForest(input);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.problems().size(), 100u);
}

} // namespace osgTreeWind
