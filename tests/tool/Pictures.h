// SPDX-License-Identifier: MIT
#pragma once

#include <tests/io/TemporaryFolder.h>

#include <gtest/gtest.h>
#include <osg/Image>
#include <osgDB/ReadFile>

#include <cstdlib>
#include <string>

/// Reads a picture in a folder.
inline osg::ref_ptr<osg::Image> pictureIn(const TemporaryFolder& folder, const std::string& name) {
    osg::ref_ptr<osg::Image> image = osgDB::readRefImageFile(folder.path() + '/' + name);
    EXPECT_TRUE(image) << name;
    return image ? image : osg::ref_ptr<osg::Image>(new osg::Image);
}

/// Mean difference between the bytes of two pictures.
inline double meanDifference(const osg::Image& a, const osg::Image& b) {
    EXPECT_EQ(a.s(), b.s());
    EXPECT_EQ(a.t(), b.t());
    EXPECT_EQ(a.getTotalSizeInBytes(), b.getTotalSizeInBytes());
    double sum = 0.0;
    for (unsigned i = 0; i < a.getTotalSizeInBytes(); ++i)
        sum += std::abs(a.data()[i] - b.data()[i]);
    return sum / a.getTotalSizeInBytes();
}
