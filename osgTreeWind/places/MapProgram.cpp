// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/MapProgram.h>

#include <osgTreeWind/base/Problem.h>

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

void MapProgram::send(MapRequest message) {
    const std::lock_guard lock(_mutex);
    sendRequest(message);
}

bool MapProgram::sendRequest(MapRequest& message) {
    const bool hasEnded = _process && _process->descriptor() < 0;
    if (!_process || (hasEnded && _files.empty()))
        _process.emplace(mapReader, _files);
    _requestedFile = _files.empty() ? std::string() : _files.front();
    for (const std::string& file : _files)
        if (!message.texts.empty() && file == message.texts.front())
            _requestedFile = file;
    return _process->descriptor() >= 0 && Wire::sender(_process->descriptor()).transfer(message);
}

Diagnostic MapProgram::problem() {
    const std::string reason = (_process->started() ? "cannot be read: " : "") + _process->problem();
    return _requestedFile.empty() ? keyProblem("crs", reason) : fileProblem(_requestedFile, reason);
}

} // namespace osgTreeWind
