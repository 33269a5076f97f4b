// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/ReaderProcess.h>
#include <osgTreeWind/places/MapMessages.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// The program osgtreewind-map, which reads rasters, map features and coordinate systems through GDAL and
/// PROJ. It runs in a process of its own, so that the library needs neither, and a damaged file ends that
/// process only. The process begins with the first question and ends with this object. Any thread may ask;
/// one question is answered at a time.
class MapProgram {
public:
    /// The one for coordinate systems. Hold it over several questions, so that they are asked of one process.
    static std::shared_ptr<MapProgram> shared();

    /// @param files that it is to read or write; their sizes limit its memory and time. Empty: none.
    explicit MapProgram(std::vector<std::string> files = {});

    /// Sends a question and waits for its answer.
    template <typename Answer>
    Result<Answer> ask(MapQuestion question) {
        const std::lock_guard lock(_mutex);
        return put(question) ? take<Answer>() : Result<Answer>(problem());
    }
    /// The same of a question that a value follows.
    template <typename Answer, typename Value>
    Result<Answer> ask(MapQuestion question, Value& value) {
        const std::lock_guard lock(_mutex);
        return put(question) && Wire::sender(_process->descriptor()).pass(value) ? take<Answer>()
                                                                                 : Result<Answer>(problem());
    }
    /// Sends a question whose answer get() takes later. For a program that one object holds.
    void send(MapQuestion question);
    /// Waits for the answer to what was sent, or for the next part of an answer.
    template <typename Answer>
    Result<Answer> get() {
        const std::lock_guard lock(_mutex);
        return take<Answer>();
    }

private:
    bool put(MapQuestion& question);
    template <typename Answer>
    Result<Answer> take() {
        auto answer = _process ? Wire::receive<Answer>(_process->descriptor()) : std::nullopt;
        return answer ? std::move(*answer) : Result<Answer>(problem());
    }
    /// Why there is no answer. Ends the process.
    Diagnostic problem();

    std::mutex _mutex;
    const std::vector<std::string> _files;
    std::string _asked; ///< The file of the last question; empty: none.
    std::optional<ReaderProcess> _process;
};

} // namespace osgTreeWind
