// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/MapProgram.h>

#include <osgTreeWind/base/Problem.h>

#include <utility>

namespace osgTreeWind {

namespace {

constexpr ReaderProgram mapReader{"osgtreewind-map", "OSGTREEWIND_MAP", "reading maps", "GDAL"};

} // namespace

std::shared_ptr<MapProgram> MapProgram::shared() {
    static std::mutex mutex;
    static std::weak_ptr<MapProgram> running;
    const std::lock_guard lock(mutex);
    std::shared_ptr<MapProgram> program = running.lock();
    if (!program)
        running = program = std::make_shared<MapProgram>();
    return program;
}

MapProgram::MapProgram(std::vector<std::string> files) : _files(std::move(files)) {}

void MapProgram::send(MapQuestion question) {
    const std::lock_guard lock(_mutex);
    put(question);
}

bool MapProgram::put(MapQuestion& question) {
    const bool hasEnded = _process && _process->descriptor() < 0;
    if (!_process || (hasEnded && _files.empty()))
        _process.emplace(mapReader, _files);
    _asked = _files.empty() ? std::string() : _files.front();
    for (const std::string& file : _files)
        if (!question.texts.empty() && file == question.texts.front())
            _asked = file;
    return _process->descriptor() >= 0 && Wire::sender(_process->descriptor()).pass(question);
}

Diagnostic MapProgram::problem() {
    const std::string reason = (_process->started() ? "cannot be read: " : "") + _process->problem();
    return _asked.empty() ? keyProblem("crs", reason) : fileProblem(_asked, reason);
}

} // namespace osgTreeWind
