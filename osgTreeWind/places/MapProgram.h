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

/// Client of the program osgtreewind-map, which reads rasters, vector features and coordinate reference
/// systems with GDAL and PROJ. It runs in a separate process so that the library does not link them and a
/// damaged file cannot crash the host. The process starts at the first request and ends with this object.
/// Thread-safe; requests are answered one at a time.
class MapProgram {
public:
    /// The instance for coordinate reference systems. Hold it to use one process for several requests.
    static std::shared_ptr<MapProgram> shared();

    /// @param files that it may read or write; their sizes limit its memory and time.
    explicit MapProgram(std::vector<std::string> files = {});

    /// Sends a request and waits for its answer.
    template <typename Answer>
    Result<Answer> request(MapRequest message) {
        const std::lock_guard lock(_mutex);
        return sendRequest(message) ? receive<Answer>() : Result<Answer>(problem());
    }
    /// Sends a request followed by a value, and waits for the answer.
    template <typename Answer, typename Value>
    Result<Answer> request(MapRequest message, Value& value) {
        const std::lock_guard lock(_mutex);
        return sendRequest(message) && Wire::sender(_process->descriptor()).transfer(value)
                   ? receive<Answer>()
                   : Result<Answer>(problem());
    }
    /// Sends a request without waiting for its answer (receiveNext()). Only for an unshared program.
    void send(MapRequest message);
    /// Waits for the answer to send(), or for the next part of an answer.
    template <typename Answer>
    Result<Answer> receiveNext() {
        const std::lock_guard lock(_mutex);
        return receive<Answer>();
    }

private:
    bool sendRequest(MapRequest& message);
    template <typename Answer>
    Result<Answer> receive() {
        auto answer = _process ? Wire::receive<Answer>(_process->descriptor()) : std::nullopt;
        return answer ? std::move(*answer) : Result<Answer>(problem());
    }
    /// Why there was no answer. Ends the process.
    Diagnostic problem();

    std::mutex _mutex;
    const std::vector<std::string> _files;
    std::string _requestedFile; ///< File of the last request; may be empty.
    std::optional<ReaderProcess> _process;
};

} // namespace osgTreeWind
