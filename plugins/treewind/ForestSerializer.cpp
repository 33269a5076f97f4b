// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/ForestTechnique.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/gpu/ExceptionGuard.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/nodes/Forest.h>

#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>

#include <sstream>

// Writes a Forest to .osgt, .osgb and .osgx as a .treewind document of its current state, with its wind, from
// which the reader builds it again: kilobytes instead of the geometry. The host's children and technique are
// written as OSG objects.
namespace {

using osgTreeWind::Forest;

/// Runs a function that osgDB calls, without exceptions.
template <typename Entry>
bool guarded(const Entry& entry) {
    const osgTreeWind::ExceptionGuard guard;
    return guard.run("a Forest cannot be written or read", entry);
}

void report(const osgTreeWind::Diagnostics& problems) {
    if (!problems.empty())
        OSG_WARN << "osgTreeWind: " << toString(problems) << std::endl;
}

/// The .treewind document of a forest. Omits a wind or a ground that has no file form, with a warning.
/// Returns a problem if the forest cannot be written at all.
osgTreeWind::Result<std::string> writeDocumentText(const Forest& forest) {
    osgTreeWind::ForestDescription now = forest.getSimulation().currentDescription();
    for (;;) {
        std::ostringstream document;
        const osgTreeWind::Diagnostics problems = writeForest(now, document);
        if (problems.empty())
            return document.str();
        const std::string& key = problems.front().key;
        if (key != "wind" && key != "ground")
            return problems;
        OSG_WARN << "osgTreeWind: a Forest is written without its " << key << ": " << problems.front().text()
                 << std::endl;
        if (key == "wind")
            now.wind = nullptr;
        else
            now.ground = nullptr;
    }
}

bool checkDocument(const Forest&) {
    return true;
}

bool writeDocument(osgDB::OutputStream& output, const Forest& forest) {
    return guarded([&] {
        const osgTreeWind::Result<std::string> document = writeDocumentText(forest);
        if (!document) // without brackets, so that no reader takes the rest for a forest
            return output.throwException("a Forest cannot be written: " + document.problems().front().text());
        output << output.BEGIN_BRACKET << std::endl;
        output << output.PROPERTY("Folder");
        output.writeWrappedString(forest.getDescription().folder);
        output << std::endl << output.PROPERTY("Source");
        output.writeWrappedString(document.value());
        output << std::endl << output.END_BRACKET << std::endl;
    });
}

/// Builds the forest of a document. If that fails, the forest stays empty, with a warning, so that the rest
/// of the scene can be used.
void readForestInto(Forest& forest, const std::string& source, const osgTreeWind::ForestFileOptions& where) {
    std::istringstream document(source);
    osgTreeWind::Result<osgTreeWind::ForestFile> description = osgTreeWind::readForest(document, where);
    report(description ? forest.setDescription(std::move(description.value())) : description.problems());
}

/// Reads a text with a name. @return false if something else is there: in a damaged file, readWrappedString()
/// of OSG might not end.
bool readText(osgDB::InputStream& input, const char* name, std::string& text) {
    osgDB::ObjectProperty property(name);
    input >> property;
    if (property._name != name || input.getException())
        return false;
    input.readWrappedString(text);
    return true;
}

bool readDocument(osgDB::InputStream& input, Forest& forest) {
    osgTreeWind::ForestFileOptions where;
    std::string source;
    bool isComplete = false;
    const bool isRead = guarded([&] {
                            input >> input.BEGIN_BRACKET;
                            isComplete =
                                readText(input, "Folder", where.folder) && readText(input, "Source", source);
                            input >> input.END_BRACKET;
                        }) &&
                        isComplete;
    if (isRead)
        guarded([&] { readForestInto(forest, source, where); });
    return isRead;
}

/// Whether a child is written as an object: a child of the host, or a technique of the host.
bool isWritten(const Forest& forest, const osg::Node& child) {
    const bool isUsual = child.libraryName() == std::string("osgTreeWind");
    return !forest.isOwnChild(&child) || (&child == forest.getTechnique() && !isUsual);
}

unsigned countOtherChildren(const Forest& forest) {
    unsigned count = 0;
    for (unsigned i = 0; i < forest.getNumChildren(); ++i)
        count += isWritten(forest, *forest.getChild(i));
    return count;
}

bool checkOtherChildren(const Forest& forest) {
    return countOtherChildren(forest) > 0;
}

bool writeOtherChildren(osgDB::OutputStream& output, const Forest& forest) {
    return guarded([&] {
        output << countOtherChildren(forest) << output.BEGIN_BRACKET << std::endl;
        for (unsigned i = 0; i < forest.getNumChildren(); ++i)
            if (isWritten(forest, *forest.getChild(i)))
                output << forest.getChild(i);
        output << output.END_BRACKET << std::endl;
    });
}

bool readOtherChildren(osgDB::InputStream& input, Forest& forest) {
    return guarded([&] {
        unsigned count = 0;
        input >> count >> input.BEGIN_BRACKET;
        for (unsigned i = 0; i < count && !input.getException(); ++i) {
            osg::ref_ptr<osg::Node> child = input.readObjectOfType<osg::Node>();
            if (auto* technique = dynamic_cast<osgTreeWind::ForestTechnique*>(child.get()))
                report(forest.setTechnique(technique));
            else if (child)
                forest.addChild(child);
        }
        input >> input.END_BRACKET;
    });
}

// Releases before 2.0 wrote two modes of drawing, which do not exist any more.
bool checkBranchwiseDrawing(const Forest&) {
    return false;
}

bool writeBranchwiseDrawing(osgDB::OutputStream&, const Forest&) {
    return true;
}

bool readBranchwiseDrawing(osgDB::InputStream& input, Forest&) {
    int branches = 0, leaves = 0;
    input >> branches >> leaves;
    return true;
}

} // namespace

/// For USE_SERIALIZER_WRAPPER_LIBRARY(osgtreewind) in programs that link this library statically.
extern "C" void wrapper_serializer_library_osgtreewind() {}

// Without osg::Group, whose wrapper would write the children.
REGISTER_OBJECT_WRAPPER(osgTreeWind_Forest, new osgTreeWind::Forest, osgTreeWind::Forest,
                        "osg::Object osg::Node osgTreeWind::Forest") {
    ADD_USER_SERIALIZER(Document);
    ADD_USER_SERIALIZER(OtherChildren);
    ADD_USER_SERIALIZER(BranchwiseDrawing);
}
