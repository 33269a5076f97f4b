// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Guarded.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/places/HostMap.h>
#include <plugins/treewind/StatisticsLinesCallback.h>

#include <osg/MatrixTransform>

#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/Registry>

#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace osgTreeWind;

/// Reads .treewind files (docs/treewind.md) as a Forest, and writes the current state of a Forest. Stateless,
/// so that threads of pagers may share it.
class ReaderWriterTreewind : public osgDB::ReaderWriter {
public:
    ReaderWriterTreewind() {
        supportsExtension("treewind", "osgTreeWind forest description");
        supportsOption("treewind.KEY=VALUE",
                       "overrides a key of the file, for example treewind.wind.speed=15");
    }

    const char* className() const override { return "osgTreeWind forest reader and writer"; }

    ReadResult readObject(const std::string& file, const Options* options) const override {
        return readNode(file, options);
    }
    ReadResult readObject(std::istream& input, const Options* options) const override {
        return readNode(input, options);
    }

    ReadResult readNode(const std::string& file, const Options* options) const override {
        return guarded<ReadResult>([&]() -> ReadResult {
            if (!acceptsExtension(osgDB::getLowerCaseFileExtension(file)))
                return ReadResult::FILE_NOT_HANDLED;
            const std::string path = osgDB::findDataFile(file, options);
            if (path.empty())
                return ReadResult::FILE_NOT_FOUND;
            return makeForestNode(readForestFile(path, ForestFileOptions().maxTrees, findSettings(options)),
                                  path);
        });
    }

    /// Relative paths start at the first folder of the options' database paths.
    ReadResult readNode(std::istream& input, const Options* options) const override {
        return guarded<ReadResult>([&] {
            ForestFileOptions where;
            where.settings = findSettings(options);
            if (options && !options->getDatabasePathList().empty())
                where.folder = options->getDatabasePathList().front();
            return makeForestNode(readForest(input, where), where.file);
        });
    }

    WriteResult writeObject(const osg::Object& object, const std::string& file,
                            const Options* options) const override {
        const osg::Node* const node = object.asNode();
        return node ? writeNode(*node, file, options) : WriteResult(WriteResult::FILE_NOT_HANDLED);
    }
    WriteResult writeObject(const osg::Object& object, std::ostream& output,
                            const Options* options) const override {
        const osg::Node* const node = object.asNode();
        return node ? writeNode(*node, output, options) : WriteResult(WriteResult::FILE_NOT_HANDLED);
    }

    WriteResult writeNode(const osg::Node& node, const std::string& file, const Options*) const override {
        return guarded<WriteResult>([&]() -> WriteResult {
            if (!acceptsExtension(osgDB::getLowerCaseFileExtension(file)))
                return WriteResult::FILE_NOT_HANDLED;
            return write(node,
                         [&](const ForestDescription& forest) { return writeForestFile(forest, file); });
        });
    }
    WriteResult writeNode(const osg::Node& node, std::ostream& output, const Options*) const override {
        return guarded<WriteResult>([&] {
            return write(node, [&](const ForestDescription& forest) { return writeForest(forest, output); });
        });
    }

private:
    /// The result of a function that osgDB calls; an error if it throws.
    template <typename ResultType, typename Function>
    static ResultType guarded(const Function& function) {
        ResultType result((std::string()));
        const std::string problem = runGuarded([&] { result = function(); });
        return problem.empty() ? result : ResultType("osgTreeWind: " + problem);
    }

    /// The words of an options string that begin with "treewind.", without this prefix, as in
    /// `-O "treewind.season=autumn"`.
    static std::vector<std::string> findSettings(const Options* options) {
        const std::string prefix = "treewind.";
        std::vector<std::string> settings;
        std::istringstream words(options ? options->getOptionString() : "");
        for (std::string word; words >> word;)
            if (word.compare(0, prefix.size(), prefix) == 0)
                settings.push_back(word.substr(prefix.size()));
        return settings;
    }

    static ReadResult makeForestNode(Result<ForestFile> forest, const std::string& file) {
        if (!forest)
            return ReadResult(toString(forest.problems()));
        const std::vector<std::string> notes = forest.value().notes;
        Result<osg::ref_ptr<Forest>> node = Forest::create(std::move(forest.value()));
        if (!node) {
            Diagnostic problem = node.problems().front();
            problem.file = file;
            return ReadResult(problem.text());
        }
        for (const std::string& note : notes)
            OSG_NOTICE << "osgTreeWind: " << note << std::endl;
        node.value()->setEventCallback(new StatisticsLinesCallback);
        node.value()->setName(osgDB::getSimpleFileName(file));
        return placeOnMap(*node.value());
    }

    /// The forest, below a transform to the map of the host if the file names one.
    static ReadResult placeOnMap(Forest& forest) {
        const ForestDescription& description = forest.getDescription();
        if (description.hostCrs.empty())
            return &forest;
        const Result<glm::dmat4> place =
            hostMapTransform(description.crs, description.origin, description.hostCrs);
        if (!place)
            return ReadResult(toString(place.problems()));
        osg::ref_ptr<osg::MatrixTransform> transform =
            new osg::MatrixTransform(osg::Matrixd(&place.value()[0][0]));
        transform->setName(forest.getName());
        transform->addChild(&forest);
        return transform.get();
    }

    /// The forest in the result of placeOnMap().
    static const osg::Node& removeMapTransform(const osg::Node& node) {
        const osg::Group* const group = node.asTransform();
        const auto forest =
            group && group->getNumChildren() == 1 ? dynamic_cast<const Forest*>(group->getChild(0)) : nullptr;
        return forest && !forest->getDescription().hostCrs.empty() ? *forest : node;
    }

    /// Writes a Forest without children of the host.
    template <typename Writer>
    static WriteResult write(const osg::Node& node, const Writer& writer) {
        const auto forest = dynamic_cast<const Forest*>(&removeMapTransform(node));
        if (!forest)
            return WriteResult(std::string("a .treewind file holds a Forest, not a ") + node.className());
        for (unsigned i = 0; i < forest->getNumChildren(); ++i)
            if (!forest->isOwnChild(forest->getChild(i)))
                return WriteResult("a .treewind file does not hold the forest's child " +
                                   forest->getChild(i)->getName());
        ForestDescription now = forest->getSimulation().currentDescription();
        const Diagnostics problems = writer(now);
        return problems.empty() ? WriteResult(WriteResult::FILE_SAVED) : WriteResult(toString(problems));
    }
};

} // namespace

REGISTER_OSGPLUGIN(treewind, ReaderWriterTreewind)
