// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Notify>

#include <mutex>
#include <string>
#include <utility>

/// Keeps what OSG says at NOTICE and above, for any thread, but for how a forest gets on that takes over a
/// second to grow: on a slow machine any does.
class MessageCollector : public osg::NotifyHandler {
public:
    void notify(osg::NotifySeverity severity, const char* message) override {
        const std::lock_guard<std::mutex> lock(_mutex);
        const bool patience = std::string(message).rfind("osgTreeWind: growing a forest", 0) == 0;
        if (severity <= osg::NOTICE && !patience)
            _messages += message;
    }
    /// Everything kept so far, which is then forgotten.
    std::string take() {
        const std::lock_guard<std::mutex> lock(_mutex);
        return std::exchange(_messages, std::string());
    }

private:
    std::mutex _mutex;
    std::string _messages;
};
