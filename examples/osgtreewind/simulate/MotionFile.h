// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/simulate/MotionTable.h>

#include <memory>

/// File to which a table is written step by step. It appears when it is complete. Throws CommandError on a
/// write error.
class MotionFile {
public:
    virtual ~MotionFile() = default;
    virtual void write(double time) = 0; ///< Writes the present state. @param time seconds.
    virtual void finish() = 0;
};

// `table` and `simulation` must outlive the file.

/// @param path "-" for standard output.
std::unique_ptr<MotionFile> createMotionCsv(const std::string& path, const MotionTable& table,
                                            const osgTreeWind::ForestSimulation& simulation);
/// NetCDF-4 after the CF conventions, over time and tree or, for units, over time and unit.
/// @param steps number of steps that will be written, which sets the size of chunks.
std::unique_ptr<MotionFile> createMotionNetCdf(const std::string& path, const MotionTable& table,
                                               const osgTreeWind::ForestSimulation& simulation,
                                               std::size_t steps);
