// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/ForestStream.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/io/ForestSections.h>

#include <utility>

namespace osgTreeWind {

struct ForestStream::Reading : ForestReading {};

ForestStream::ForestStream() = default;
ForestStream::ForestStream(ForestStream&&) noexcept = default;
ForestStream& ForestStream::operator=(ForestStream&&) noexcept = default;
ForestStream::~ForestStream() = default;

Result<ForestStream> ForestStream::read(const std::string& path, const ForestStreamOptions& options) {
    ForestStream stream;
    stream._reading = std::make_unique<Reading>();
    Reading& reading = *stream._reading;
    if (!reading.trees.spool().useFile(options.folder, options.treesAtOnce))
        return fileProblem(options.folder, "cannot be written");
    readDocumentFile(path, options.maxTrees, {}, reading);
    reading.trees.spool().flush();
    if (reading.trees.spool().hasFailed())
        return fileProblem(options.folder, "cannot hold " + std::to_string(reading.trees.size()) +
                                               " trees while they are read, 72 bytes each and their ids");
    if (!reading.log.problems.empty())
        return std::move(reading.log.problems);
    reading.trees.forgetNames();
    return stream;
}

const ForestFile& ForestStream::file() const {
    return _reading->forest;
}

std::size_t ForestStream::treeCount() const {
    return _reading->trees.size();
}

bool ForestStream::visit(const std::function<void(const std::vector<TreePlacement>&)>& visitor) const {
    _reading->trees.visit(visitor);
    return !_reading->trees.spool().hasFailed();
}

} // namespace osgTreeWind
