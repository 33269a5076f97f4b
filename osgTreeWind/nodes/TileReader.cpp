// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/TileReader.h>

#include <osgTreeWind/nodes/TreeTile.h>

#include <osgDB/FileNameUtils>
#include <osgDB/Registry>

#include <fstream>

namespace osgTreeWind {

namespace {

/// Not a plugin: a host that made its forest in code, without any, reads them too.
class TileReader : public osgDB::ReaderWriter {
public:
    TileReader() { supportsExtension("trees", "a tile of an osgTreeWind forest"); }
    const char* className() const override { return "osgTreeWind tile reader"; }

    ReadResult readNode(const std::string& file, const Options*) const override {
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(file)) || osgDB::containsServerAddress(file))
            return ReadResult::FILE_NOT_HANDLED; // OSG brings a server's as a stream
        std::ifstream input(file, std::ios::binary);
        return input ? read(input, file) : ReadResult(ReadResult::FILE_NOT_FOUND);
    }
    ReadResult readNode(std::istream& input, const Options* options) const override {
        return read(input, options ? options->getPluginStringData("STREAM_FILENAME") : std::string());
    }

private:
    static ReadResult read(std::istream& input, const std::string& file) {
        Result<osg::ref_ptr<TreeTile>> tile = TreeTile::read(input, file);
        return tile ? ReadResult(tile.value().get()) : ReadResult(tile.problems().front().text());
    }
};

} // namespace

void registerTileReader() {
    static const osgDB::RegisterReaderWriterProxy<TileReader> reader;
}

} // namespace osgTreeWind
