// SPDX-License-Identifier: MIT
#pragma once

#include <osgViewer/ViewerBase>

#include <gtest/gtest.h>

#include <string>

/// All that a viewer has, for the tests that run under each of them.
inline const auto threadingModels =
    testing::Values(osgViewer::ViewerBase::SingleThreaded, osgViewer::ViewerBase::CullDrawThreadPerContext,
                    osgViewer::ViewerBase::DrawThreadPerContext,
                    osgViewer::ViewerBase::CullThreadPerCameraDrawThreadPerContext);

inline std::string nameOfModel(const testing::TestParamInfo<osgViewer::ViewerBase::ThreadingModel>& info) {
    switch (info.param) {
    case osgViewer::ViewerBase::SingleThreaded:
        return "SingleThreaded";
    case osgViewer::ViewerBase::CullDrawThreadPerContext:
        return "CullDrawThreadPerContext";
    case osgViewer::ViewerBase::DrawThreadPerContext:
        return "DrawThreadPerContext";
    default:
        return "CullThreadPerCameraDrawThreadPerContext";
    }
}
