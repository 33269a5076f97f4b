// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/TileReader.h>

#include <osgTreeWind/base/Guarded.h>
#include <osgTreeWind/base/InputFile.h>

#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/Registry>

#include <fstream>

namespace osgTreeWind {

namespace {

/// Part of the library and not a plugin, so that forests made in code need no plugin.
class TileReader : public osgDB::ReaderWriter {
public:
    TileReader() {
        supportsExtension("trees", "a tile of an osgTreeWind forest");
        supportsExtension("ids", "where trees of an osgTreeWind forest are");
        supportsExtension("crowns", "the crowns of an osgTreeWind forest as they look from afar");
    }
    const char* className() const override { return "osgTreeWind tile reader"; }

    ReadResult readNode(const std::string& file, const Options*) const override {
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(file)) || osgDB::containsServerAddress(file))
            return ReadResult::FILE_NOT_HANDLED; // OSG reads files of servers as streams
        Result<std::ifstream> input = openInput(file);
        if (input)
            return read(input.value(), file);
        return osgDB::fileExists(file) ? ReadResult(input.problems().front().text())
                                       : ReadResult(ReadResult::FILE_NOT_FOUND);
    }
    ReadResult readNode(std::istream& input, const Options* options) const override {
        const std::string file = options ? options->getPluginStringData("STREAM_FILENAME") : std::string();
        return remainingBytes(input) > maxBytes ? ReadResult(file + ": expected at most 256 MiB")
                                                : read(input, file);
    }

private:
    static constexpr std::streamoff maxBytes = 1 << 28; // of a file from a server

    static std::streamoff remainingBytes(std::istream& input) {
        const std::streampos here = input.tellg();
        const std::streampos end = input.seekg(0, std::ios::end).tellg();
        input.seekg(here);
        return end - here;
    }
    static ReadResult read(std::istream& input, const std::string& file) {
        const std::string extension = osgDB::getLowerCaseFileExtension(file);
        if (extension == "crowns")
            return readFileNode(readCrownSummary, input, file);
        if (extension == "ids")
            return readFileNode(readTileIds, input, file);
        return readFileNode(readTileTrees, input, file);
    }
    template <typename Content>
    static ReadResult readFileNode(Result<Content> (*reader)(std::istream&, const std::string&),
                                   std::istream& input, const std::string& file) {
        ReadResult result(ReadResult::ERROR_IN_READING_FILE);
        const std::string problem = runGuarded([&] {
            Result<Content> content = reader(input, file);
            if (content)
                result = ReadResult(new TileFileNode<Content>(std::move(content.value())));
            else
                result = ReadResult(content.problems().front().text());
        });
        return problem.empty() ? result : ReadResult(file + ": " + problem);
    }
};

} // namespace

void registerTileReader() {
    static const osgDB::RegisterReaderWriterProxy<TileReader> reader;
}

} // namespace osgTreeWind
