// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/pictures/WritePicture.h>

#include <examples/osgtreewind/output/CommandError.h>

#include <osgDB/FileNameUtils>
#include <osgDB/Registry>

#include <sstream>

void writePicture(const osg::Image& picture, const std::string& path, const std::string& options) {
    const std::string extension = osgDB::getLowerCaseFileExtension(path);
    osgDB::ReaderWriter* writer = osgDB::Registry::instance()->getReaderWriterForExtension(extension);
    const osg::ref_ptr<osgDB::Options> wanted = new osgDB::Options(options);
    std::ostringstream bytes; // written in memory first: OSG does not report a full disk
    if (!writer || !writer->writeImage(picture, bytes, wanted.get()).success())
        throw CommandError{Failed, path + ": cannot be written: the " + extension +
                                       " plugin of OpenSceneGraph is missing or does not write this picture"};
    writeOrThrow(path, bytes.str());
}
