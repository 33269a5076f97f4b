// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/pictures/WritePicture.h>

#include <examples/osgtreewind/output/Ending.h>

#include <osgDB/FileNameUtils>
#include <osgDB/Registry>

#include <sstream>

void writePicture(const osg::Image& picture, const std::string& path, const std::string& options) {
    const std::string extension = osgDB::getLowerCaseFileExtension(path);
    osgDB::ReaderWriter* writer = osgDB::Registry::instance()->getReaderWriterForExtension(extension);
    const osg::ref_ptr<osgDB::Options> wanted = new osgDB::Options(options);
    std::ostringstream bytes; // OSG does not tell when a disk is full
    if (!writer || !writer->writeImage(picture, bytes, wanted.get()).success())
        throw Ending{Failed, path + ": cannot be written; expected the " + extension +
                                 " plugin of OpenSceneGraph, and a format that it writes"};
    writeOrEnd(path, bytes.str());
}
