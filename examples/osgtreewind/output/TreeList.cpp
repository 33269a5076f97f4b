// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/output/TreeList.h>

#include <examples/osgtreewind/output/CommandError.h>
#include <examples/osgtreewind/output/Progress.h>

#include <osgTreeWind/base/CsvCell.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/forest/PlacedForest.h>

#include <charconv>
#include <fstream>

namespace {

using namespace osgTreeWind;

/// Shortest text that reads back as the same float.
std::string cell(float number) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

} // namespace

void writeTrees(const ForestDescription& forest, const std::string& path) {
    AtomicFile whole(path);
    std::ofstream output(whole.writePath(), std::ios::binary);
    output << "id,species,x,y,z,height,trunk_diameter,crown_width,open,leaves,given\n";
    ForestDescription shapes = forest;
    shapes.trees.clear();
    const PlacedForest placed(std::move(shapes));
    Progress progress("measure", forest.trees.size());
    for (const TreePlacement& tree : forest.trees) {
        output << csvCell(tree.name) << ',' << csvCell(forest.species[tree.species].name);
        for (int axis = 0; axis < 3; ++axis)
            output << ',' << numberText(tree.position[axis]);
        const TreeSize measured = placed.sizeOf(placed.makePlacedTree(tree));
        std::string given;
        const auto write = [&](const char* name, float size, float ofShape, bool estimated) {
            output << ',' << cell(size > 0.0f ? size : ofShape);
            if (size > 0.0f && !estimated)
                given += (given.empty() ? "" : "+") + std::string(name);
        };
        const EstimatedSizes& estimated = tree.estimated;
        write("height", tree.size.height, measured.height, estimated.height);
        write("trunk_diameter", tree.size.trunkDiameter, measured.trunkDiameter, estimated.trunkDiameter);
        write("crown_width", tree.size.crownWidth, measured.crownWidth, estimated.crownWidth);
        output << ',' << tree.openGrown << ',' << cell(tree.leaves) << ',' << (given.empty() ? "none" : given)
               << '\n';
        progress.advance();
    }
    output.close();
    if (!output || !whole.commit())
        throwWriteError(whole);
}
